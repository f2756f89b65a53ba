
/**
 * Which aircraft, and what is set on it. One of `aircraft`, `toml` and `matrices`.
 */
export interface Subject {
  /** Key of an aircraft of the list, such as "navion". */
  aircraft?: string;
  /** Text of an aircraft file. */
  toml?: string;
  /** Text of bare matrices A and B with named states. */
  matrices?: string;
  /** How `matrices` is written; "m" is MATLAB. */
  format?: "json" | "csv" | "m";
  /** Name of the text in messages. */
  file?: string;
  /** Values by the keys of `parameters()`: SI, radians. */
  set?: Record<string, number>;
}

export interface ResponseRequest {
  /** By default that of the disturbance, or the aircraft's first. */
  plane?: PlaneName;
  /** By default elevator or rudder. Its size is one of the `parameters()`. */
  disturbance?: Disturbance;
  /** By default that of the page; not every disturbance can have every shape. */
  shape?: Shape;
  /** Name of the mode flown alone, with the disturbance "mode". */
  mode?: string;
  /** Steps between the samples, 600 by default. */
  steps?: number;
  /** Whether the same is flown in six degrees of freedom, without linearising. */
  nonlinear?: boolean;
  /** Whether each output is split into the parts of the modes. */
  split?: boolean;
}

export type Disturbance =
  | "elevator"
  | "throttle"
  | "vertical-gust"
  | "head-gust"
  | "rudder"
  | "aileron"
  | "side-gust"
  | "turbulence"
  | "release"
  | "mode";
export type Shape = "step" | "pulse" | "doublet" | "3-2-1-1" | "sine" | "sweep" | "1-cosine";

export interface FrequencyRequest {
  /** By default that of the disturbance, else that of the output, else the aircraft's first. */
  plane?: PlaneName;
  /** By default elevator or rudder. */
  disturbance?: Exclude<Disturbance, "turbulence" | "release" | "mode">;
  /** Name of an output, as `respond()` gives them; "q" or "beta" by default. */
  output?: string;
  /** First angular frequency in rad/s, by default below all modes. */
  from?: number;
  /** Last angular frequency in rad/s, by default above all modes. */
  to?: number;
  /** Number of frequencies, 400 by default. */
  points?: number;
}

export interface SweepRequest {
  /** Key of the parameter. */
  parameter: string;
  /** First value, SI. */
  from: number;
  /** Last value, SI. */
  to: number;
  /** Number of values, 51 by default. */
  points?: number;
}

export type Stability = "stable" | "neutral" | "unstable";
export type PlaneName = "longitudinal" | "lateral";

export interface Aircraft {
  /** Short name; "file" for bare matrices. */
  key: string;
  name: string;
  condition: string;
  source: string;
  status: "verified" | "unverified";
  status_reason: string;
  /** Class of MIL-F-8785C. */
  class: string | null;
  /** Flight-phase category of MIL-F-8785C. */
  phase: string | null;
  planes: PlaneName[];
}

export interface Parameter {
  key: string;
  name: string;
  meaning: string;
  sign: string;
  /** SI unit; empty for a ratio. */
  unit: string;
  plane: PlaneName | null;
  value: number;
  slider: [number, number];
  accepted: [number, number];
}

export interface Analysis {
  aircraft: Aircraft;
  /** Unit of each field, by its name. */
  units: Record<string, string>;
  set: Record<string, number>;
  /** null where the aircraft has no data of it. */
  longitudinal: Plane | { error: string } | null;
  lateral: Plane | { error: string } | null;
  /** In mean chords; of an aircraft given by coefficients. */
  static_margin: number | null;
  manoeuvre_margin: number | null;
  /** False where gravity and speed can't belong to one system of units. */
  gravity_is_plausible: boolean | null;
}

export interface Plane {
  /** Names of the states in the order of rows and columns. */
  states: string[];
  /** Names of the inputs in the order of the columns of B. */
  inputs: string[];
  /** A, row by row. */
  a: number[][];
  /** B, row by row. */
  b: number[][];
  trim: { speed: number; alpha0: number; gamma0: number; gravity: number };
  /** All four as [real, imaginary]. */
  eigenvalues: [number, number][];
  /** Each conjugate pair once. */
  modes: Mode[];
  dynamic_stability: Stability;
  static_stability: StaticStability;
  approximations: Approximation[];
  levels: Level[];
}

export interface Mode {
  name: string;
  reason: string;
  confidence: number;
  re: number;
  /** Not negative; positive stands for the pair. */
  im: number;
  stability: Stability;
  natural_frequency: number | null;
  /** Negative when the oscillation grows. */
  damping_ratio: number | null;
  damped_frequency: number | null;
  period: number | null;
  time_to_half: number | null;
  time_to_double: number | null;
  cycles: number | null;
  time_constant: number | null;
  /** Share of each state, adding up to 1. */
  participation: number[];
  /** [real, imaginary] of each state, of unit length. */
  eigenvector: [number, number][];
  left_eigenvector: [number, number][];
  condition: number;
}

export interface StaticStability {
  verdict: Stability;
  /** det A. */
  determinant: number;
  /** Whether the stiffnesses are derivatives as such; else entries of A, with other derivatives folded in. */
  plain_derivatives: boolean;
  pitch_stiffness?: number;
  to_manoeuvre_point?: number | null;
  weathercock_stiffness?: number;
  dihedral_effect?: number;
  spiral_condition?: number;
}

export interface Approximation {
  mode: string;
  name: string;
  formula: string;
  neglects: string;
  value: ModeValue | null;
  exact: ModeValue | null;
  /** Relative error of the frequency or the root. */
  error: number | null;
  /** Relative error of the damping ratio. */
  damping_error: number | null;
}

export type ModeValue = { natural_frequency: number; damping_ratio: number | null } | { root: number };

export interface Level {
  criterion: string;
  level: string;
  on_boundary: boolean;
  paragraph: string;
  table: string;
  values: { symbol: string; value: number; unit: string }[];
  sentence: string;
}

export interface Motion {
  aircraft: Aircraft;
  set: Record<string, number>;
  plane: PlaneName;
  disturbance: Disturbance;
  /** null where the disturbance has one of its own. */
  shape: Shape | null;
  mode: string | null;
  /** Seconds. */
  time: number[];
  /** What disturbs; none where the aircraft is let go. */
  inputs: Signal[];
  /** What moves, as a change from the steady flight. */
  outputs: Signal[];
  /** Seconds; null if the motion stays small. */
  small_until: number | null;
  /** Seconds; null if all samples are there. */
  cut_at: number | null;
  /** Of the motion while it is a small disturbance, at 1,200 steps or more. */
  figures: Figures;
  /** One an output; null where it wasn't asked for. */
  split: (Split | { name: string; error: string })[] | null;
  /** Null where it wasn't asked for. */
  nonlinear: Flight | { error: string } | null;
}

export interface Figures {
  /** When the disturbance begins, in seconds. */
  start: number;
  outputs: OutputFigures[];
  /** Largest change, in g: normal or lateral after the plane. */
  peak_load_factor: Peak | null;
  /** Seconds after the start to 30° of bank either way; of lateral motion. */
  time_to_bank: number | null;
  /** Metres between the first two turning points of the phugoid's part of the height. */
  phugoid_swing: number | null;
  /** rad/s² per g; of the elevator. */
  control_anticipation: number | null;
}

export interface OutputFigures {
  name: string;
  /** SI unit; empty for a ratio. */
  unit: string;
  /** Farthest from zero. */
  peak: Peak | null;
  /** What it goes to after a step; null where it goes to nothing. */
  steady: number | null;
  /** Seconds from 10 % to 90 % of the steady value. */
  rise_time: number | null;
  /** Seconds after the step until it stays within 2 % of the steady value. */
  settling_time: number | null;
  /** As a fraction of the steady value; null where it hasn't gone beyond it and may yet. */
  overshoot: number | null;
}

export interface Peak {
  value: number;
  /** Seconds. */
  time: number;
}

export interface Split {
  name: string;
  unit: string;
  /** One a mode; with `rest` they add up to the output. */
  parts: { mode: string; values: number[] }[];
  /** What no mode makes: what the input does at once, and the drift of the path. */
  rest: number[];
}

export interface Flight {
  /** Seconds: the samples until it stops. */
  time: number[];
  /** As a change from the steady flight, in the order of the linear outputs. */
  outputs: Signal[];
  /** Null where it flew to the end. */
  stop: { time: number; sentence: string } | null;
}

export interface Signal {
  name: string;
  /** SI unit; empty for a ratio. */
  unit: string;
  /** One a time. */
  values: number[];
}

export interface FrequencyResponse {
  aircraft: Aircraft;
  set: Record<string, number>;
  plane: PlaneName;
  disturbance: Disturbance;
  /** Air is positive forward, downward and to the right. */
  input: { name: string; unit: string };
  output: { name: string; unit: string };
  /** Unit of the output for one of the input. */
  gain_unit: string;
  /** rad/s. */
  frequency: number[];
  /** One a frequency. */
  gain: number[];
  /** Radians, one a frequency, continuous. */
  phase: number[];
  /** Local maxima of the gain, with the oscillation nearest in frequency. */
  peaks: { mode: string; frequency: number; gain: number }[];
}

export interface Sweep {
  aircraft: Aircraft;
  units: Record<string, string>;
  set: Record<string, number>;
  parameter: string;
  unit: string;
  points: SweepPoint[];
  changes: SweepChange[];
}

export interface SweepPoint {
  value: number;
  /** null where there is no data or the parameter doesn't move it. */
  longitudinal: SweepPlane | null;
  lateral: SweepPlane | null;
  /** Why a plane has no modes here. */
  error: string | null;
}

export interface SweepPlane {
  static_stability: Stability;
  dynamic_stability: Stability;
  determinant: number;
  modes: {
    name: string;
    re: number;
    im: number;
    natural_frequency: number | null;
    damping_ratio: number | null;
  }[];
}

export interface SweepChange {
  plane: PlaneName;
  stability: "static" | "dynamic";
  between: [number, number];
  at: number;
  from: Stability;
  to: Stability;
}

