// Written by a test of src/export/typescript.rs from the Rust types, whose comments these are.

/** An aircraft's name, source and status. */
export type Aircraft = {
  /** Short name; `file` for bare matrices. */
  key: string,
  /** Name in words. */
  name: string,
  /** Flight condition in words. */
  condition: string,
  /** Source of its numbers. */
  source: string,
  /** `verified` where every published number is reproduced, else `unverified`. */
  status: Status,
  /** Reason of the status, in a sentence or two. */
  status_reason: string,
  /** Remarks on the source: misprints, what is estimated, what is our assignment. */
  notes: Array<string>,
  /** Class of MIL-F-8785C, our assignment. */
  class: AircraftClass | null,
  /** Flight-phase category of MIL-F-8785C, our assignment. */
  phase: FlightPhase | null,
  /** The planes of motion that it has data of. */
  planes: Array<PlaneName>,
};

export type AircraftClass = "I" | "II" | "II-C" | "III" | "IV";

/** The analysis of an aircraft. */
export type Analysis = {
  /** The aircraft. */
  aircraft: Aircraft,
  /** How far its numbers can be trusted as they are set, in words: the aircraft's own status is that of its file. */
  status_now: string,
  /** The unit of every number below, by the name of its field; numbers without one are ratios. */
  units: Record<string, string>,
  /** Values set on it, SI. */
  set: Record<string, number>,
  /** What of the link can't be used, in sentences; none without a link. */
  notices: Array<string>,
  /** Longitudinal motion, x = [u, w, q, θ]; null where the aircraft has no data of it. */
  longitudinal: PlaneOutcome | null,
  /** Lateral–directional motion, x = [v, p, r, φ]. */
  lateral: PlaneOutcome | null,
  /** Static margin in mean chords, positive where stable; of an aircraft given by coefficients only. */
  static_margin: number | null,
  /** Manoeuvre margin in mean chords. */
  manoeuvre_margin: number | null,
  /** The level of handling qualities as a whole; null where nothing is judged. */
  overall_level: OverallLevel | null,
  /** False where gravity and speed of the model can't belong to one system of units. */
  gravity_is_plausible: boolean | null,
};

/** A textbook approximation beside the exact mode. */
export type Approximation = {
  /** Name of the mode that it approximates. */
  mode: string,
  /** Key of the mode. */
  mode_key: ModeKey,
  /** Name of the approximation, among those of the mode. */
  name: string,
  /** Key of the approximation, among all. */
  key: ApproximationKey,
  /** Its formula. */
  formula: string,
  /** Terms and motions that it leaves out. */
  neglects: string,
  /** Its result; null where it gives none. */
  value: ModeValue | null,
  /** The exact mode; null where the aircraft has none. */
  exact: ModeValue | null,
  /** Relative error of ωₙ or of the root. */
  error: number | null,
  /** Relative error of ζ. */
  damping_error: number | null,
};

export type ApproximationKey = "short-period-two-states" | "short-period-pitch-only" | "phugoid-lanchester" | "phugoid-two-states" | "phugoid-residualised" | "phugoid-quartic" | "dutch-roll-two-states" | "dutch-roll-yaw-only" | "roll-damping" | "spiral-polynomial" | "spiral-with-gravity" | "spiral-quick";

/** A time through which a limit holds a control back. */
export type AtLimit = {
  /** Key of the control. */
  control: string,
  /** `deflection` or `rate`. */
  limit: string,
  /** From when [s]. */
  from: number,
  /** Until when [s]. */
  until: number,
};

/** A plane of motion under its law of feedback, with the further states of its source. */
export type ClosedLoop = {
  /** Whether a law feeds anything back; otherwise it is the aircraft with the further states of its source. */
  feedback: boolean,
  /** Keys of all states: the four of the aircraft, the further ones of its source, and those of the law. */
  states: Array<string>,
  /** State matrix of the whole, row by row. */
  a: Array<Array<number>>,
  /** All eigenvalues as [real part, imaginary part], each pair with both, in the order of the modes. */
  eigenvalues: Array<[number, number]>,
  /** The modes, each conjugate pair once. */
  modes: Array<LoopMode>,
  /** `stable`, `neutral` or `unstable`: that of the worst mode. */
  dynamic_stability: Stability,
  /** Handling qualities after MIL-F-8785C, where the aircraft has a class. */
  levels: Array<Level>,
  /** The loop of each control that the law moves, cut before its actuator, the other one closed. */
  loops: Array<LoopMargins>,
  /** How much of each gain that isn't zero the plane needs to be at Level 1, all else as it is; none where the aircraft has no class. */
  least_gains: Array<LeastGain>,
};

export type ControlOrGust = "elevator" | "throttle" | "vertical-gust" | "head-gust" | "rudder" | "aileron" | "side-gust";

export type CriterionKey = "airspeed-divergence" | "pitch-divergence" | "phugoid" | "short-period-damping" | "short-period-frequency" | "dutch-roll" | "roll-mode" | "spiral" | "coupled-roll-spiral";

export type Disturbance = "elevator" | "throttle" | "vertical-gust" | "head-gust" | "rudder" | "aileron" | "side-gust" | "turbulence" | "release" | "mode" | "pitch-command" | "speed-command" | "height-command" | "bank-command" | "yaw-rate-command" | "heading-command";

/** A disturbance, and how its motion is shown. */
export type DisturbanceRequest = {
  /** `longitudinal` or `lateral`; by default that of the disturbance or of the scene. */
  plane?: PlaneName,
  /** Key of the disturbance; by default that of the scene. Its size is a parameter. */
  disturbance?: Disturbance,
  /** Its shape in time, of those it can have. */
  shape?: Shape,
  /** The mode that is flown alone, by its key or its number, with the disturbance `mode`. */
  mode?: string,
  /** Whether the nonlinear flight is drawn too. */
  nonlinear?: boolean,
  /** Whether motions over time are split into modes. */
  split?: boolean,
};

/** Figures of a motion, from its beginning to where it is no small disturbance any more. Peaks and the time to bank are of the time
 * shown, all others of the whole motion. */
export type Figures = {
  /** When the disturbance begins [s]: times after it count from here. */
  start: number,
  /** Metrics of each output, in their order. */
  outputs: Array<OutputFigures>,
  /** Largest change of the load factor, normal or lateral after the plane, with its sign; null where it is no peak. */
  peak_load_factor: Peak | null,
  /** Load factor where the linear model ends while it is still growing; null where it has a peak. */
  load_factor_beyond: number | null,
  /** Whether there are no steady values only because the linear model ends on the way to them. */
  steady_is_beyond: boolean,
  /** Time after the start at which the bank angle first is 30° either way [s]; of lateral motion but in turbulence. */
  time_to_bank: number | null,
  /** Height between the first two turning points of the phugoid's part of the height [m]; of longitudinal motion but in turbulence. */
  phugoid_swing: number | null,
  /** First pitch acceleration over the load factor at which the short period settles [rad/s² per g]; of the elevator. */
  control_anticipation: number | null,
};

/** What a file holds and what stands in the way of using it.
 *
 * Nothing in it is mended. A remedy is a value for a field, which counts once it is given as one. */
export type FileReview = {
  /** Name of the file. */
  file: string,
  /** Key of the form that it is in. */
  format: string,
  /** The form in words. */
  format_name: string,
  /** Title, as the file has it. */
  title: string,
  /** What the aircraft is made of: `coefficients`, `derivatives` or `matrices`. */
  basis: string,
  /** Each number that was read, in the order of the file. */
  read: Array<ReadQuantity>,
  /** Eigenvalues of the matrices that were read, by plane; empty where none were. */
  eigenvalues: Array<PlaneEigenvalues>,
  /** What was made of them, a sentence or two each: units, axes, signs turned, states left out, digits lost. */
  remarks: Array<string>,
  /** What can be filled in. The aircraft waits for those that are required. */
  fields: Array<ReviewField>,
  /** What looks wrong. */
  doubts: Array<ReviewDoubt>,
  /** The aircraft as the text of an aircraft file; `None` while something is missing or stops it. */
  aircraft: string | null,
};

/** A nonlinear flight in six degrees of freedom. */
export type Flight = {
  /** Times of its samples [s]: those of the linear motion until it stops, and on where that is cut. */
  time: Array<number>,
  /** Outputs, as changes from the steady flight, in the order of the linear motion's. */
  outputs: Array<Signal>,
  /** Controls of the plane away from the steady flight, with what a law of feedback moves, at these times. */
  controls: Array<Signal>,
  /** Where limits of the controls hold a law back, or the pilot under one; none without a law. */
  limits: Array<AtLimit>,
  /** The same in sentences, one a limit. */
  limit_sentences: Array<string>,
  /** Early end of the flight; null where it flew to the end. */
  stop: Stop | null,
};

/** A nonlinear flight, or why there is none. */
export type FlightOutcome = Flight | {
  /** Reason, in one sentence. */
  error: string,
};

export type FlightPhase = "A-combat" | "A" | "B" | "C";

/** An input, an output, and the frequencies. */
export type FrequencyRequest = {
  /** `longitudinal` or `lateral`; by default that of the disturbance, else that of the output, else the aircraft's first. */
  plane?: PlaneName,
  /** Key of a control or a gust, which disturbs by one channel; by default the plane's first, elevator or rudder. */
  disturbance?: ControlOrGust,
  /** Key of an output, as a motion names them; by default that of the link, else the pitch rate `q` or the sideslip `beta`. */
  output?: string,
  /** First angular frequency [rad/s]; by default below all modes, on a whole decade. */
  from?: number,
  /** Last angular frequency [rad/s]; by default above all modes, on a whole decade. */
  to?: number,
  /** Number of frequencies, evenly spread over a logarithmic axis, both ends among them; 400 by default. */
  points?: number,
};

/** A frequency response. */
export type FrequencyResponse = {
  /** The aircraft. */
  aircraft: Aircraft,
  /** Values set on it, SI. */
  set: Record<string, number>,
  /** What of the link can't be used, in sentences; none without a link. */
  notices: Array<string>,
  /** `longitudinal` or `lateral`. */
  plane: PlaneName,
  /** Key of the disturbance. */
  disturbance: ControlOrGust,
  /** The input, in the sense of the disturbance's size: air is positive where it rises, comes from ahead or moves to the right. */
  input: Measured,
  /** The output. */
  output: Measured,
  /** Unit of the gain: that of the output for one of the input. */
  gain_unit: string,
  /** Angular frequencies ω [rad/s]; without those at which the response is infinite. */
  frequency: Array<number>,
  /** Gain |G(jω)|, one a frequency. */
  gain: Array<number>,
  /** Phase of G(jω) [rad], one a frequency: continuous, and between −π and π at the first. */
  phase: Array<number>,
  /** Local maxima of the gain in order, with the oscillations that make them; none where a mode grows. */
  peaks: Array<GainPeak>,
  /** The transfer function in factored form; null where its roots can't be had. */
  transfer_function: TransferFunction | null,
  /** Gain and phase under the law of feedback at these frequencies; null where nothing is fed back. All else is of the aircraft
   * without it. */
  closed_loop: LoopFrequency | null,
  /** Name of a mode that grows: then no steady oscillation ever answers a sine, and the numbers are only the transfer function
   * at s = jω. Null where every mode stays. */
  growing_mode: string | null,
  /** Its key. */
  growing_mode_key: ModeKey | null,
};

/** A local maximum of the gain. */
export type GainPeak = {
  /** Name of the oscillation nearest in frequency. */
  mode: string,
  /** Its key. */
  mode_key: ModeKey,
  /** Its angular frequency [rad/s], to seven digits or so: a maximum is flat. */
  frequency: number,
  /** Gain there; null where it has no bound, at an oscillation that neither dies away nor grows. */
  gain: number | null,
};

/** A value that was judged. */
export type JudgedValue = {
  /** Its symbol. */
  symbol: string,
  /** The value. */
  value: number,
  /** Its unit. */
  unit: string,
};

/** The least of a gain with which its plane is at Level 1. */
export type LeastGain = {
  /** Key of the gain. */
  gain: string,
  /** Its SI unit; empty for a ratio. */
  unit: string,
  /** The one nearest to zero, of either sign; zero where none is needed, null where none of its slider reaches Level 1. */
  least: number | null,
  /** Why none does, in words. */
  reason: string | null,
};

/** A level of handling qualities. */
export type Level = {
  /** The criterion in words. */
  criterion: string,
  /** Key of the criterion. */
  criterion_key: CriterionKey,
  /** Keys of the modes that are judged. */
  modes: Array<ModeKey>,
  /** The level in words; null where the oscillation that the requirement is on is gone. */
  level: string | null,
  /** Key of the level. */
  level_key: LevelKey | null,
  /** Whether a value equals a limit to three digits. */
  on_boundary: boolean,
  /** Paragraph of MIL-F-8785C. */
  paragraph: string,
  /** Its table or figure, and page. */
  table: string,
  /** The values judged. */
  values: Array<JudgedValue>,
  /** The verdict with the limit that governs it, in one sentence. */
  sentence: string,
};

export type LevelKey = "level-1" | "level-2" | "level-3" | "worse-than-level-3";

/** A scene as a link. */
export type Link = {
  /** The link, with its `#` and the address before that if there is one. */
  link: string,
  /** What of the link in the request can't be used, in sentences. */
  notices: Array<string>,
};

/** An answer over frequency under a law. */
export type LoopFrequency = {
  /** Gain |G(jω)|, one a frequency. */
  gain: Array<number>,
  /** Phase of G(jω) [rad], one a frequency, between −π and π at the first. */
  phase: Array<number>,
  /** The transfer function under the law. */
  transfer_function: TransferFunction | null,
};

/** How far a loop is from instability. */
export type LoopMargins = {
  /** Key of the control. */
  control: string,
  /** Factor above 1 on all gains to it at which it is neutral; null where none is. */
  raise: number | null,
  /** Frequency at which it then oscillates [rad/s]. */
  raise_frequency: number | null,
  /** Factor below 1 on all gains to it at which it is neutral; null where none is. */
  lower: number | null,
  /** Frequency at which it then oscillates [rad/s]; zero where it diverges. */
  lower_frequency: number | null,
  /** Lag around the loop [rad] at which it is neutral, negative of a lead: the smallest of all crossovers. */
  phase_margin: number | null,
  /** Crossover frequency [rad/s], where the gain around the loop is 1. */
  crossover: number | null,
  /** Greatest of |1/(1 + L)|; null where it is above 1 nowhere. */
  sensitivity_peak: number | null,
  /** Frequency of that [rad/s]. */
  sensitivity_frequency: number | null,
  /** Turns of L around −1, clockwise: growing roots of the closed loop less those of the loop cut. */
  turns: number | null,
};

/** A mode under a law: its numbers, its share in the aircraft's states, and in all. */
export type LoopMode = {
  /** Share of each state, adding up to 1. */
  participation_of_all: Array<number>,
  /** Right eigenvector over all states, of unit length. */
  eigenvector_of_all: Array<[number, number]>,
  /** Left eigenvector over all states, of unit length. */
  left_eigenvector_of_all: Array<[number, number]>,
  /** Key of the mode. */
  key: ModeKey,
  /** Name of the mode. */
  name: string,
  /** Why, with numbers. */
  reason: string,
  /** Share of the mode in the states that gave it its name, 0 to 1. */
  confidence: number,
  /** Real part σ of its eigenvalue. */
  re: number,
  /** Imaginary part ω ≥ 0 of its eigenvalue; positive stands for the pair σ ± jω. */
  im: number,
  /** `stable`, `neutral` or `unstable`. */
  stability: Stability,
  /** ωₙ, of an oscillation. */
  natural_frequency: number | null,
  /** ζ, negative when it grows; of an oscillation. */
  damping_ratio: number | null,
  /** ω_d, of an oscillation. */
  damped_frequency: number | null,
  /** T, of an oscillation. */
  period: number | null,
  /** t½, of what dies away. */
  time_to_half: number | null,
  /** t₂, of what grows. */
  time_to_double: number | null,
  /** Oscillations until the amplitude has halved or doubled. */
  cycles: number | null,
  /** τ = −1/λ, of a real mode. */
  time_constant: number | null,
  /** Share of each state, adding up to 1. */
  participation: [number, number, number, number],
  /** Right eigenvector of unit length, [real, imaginary] of each state. */
  eigenvector: [[number, number], [number, number], [number, number], [number, number]],
  /** Left eigenvector l of unit length, lᴴ A = λ lᴴ. */
  left_eigenvector: [[number, number], [number, number], [number, number], [number, number]],
  /** Condition number of λ, its greatest movement for a relative change of A: 1 at best, 1e16 at a repeated root. */
  condition: number,
};

/** A motion under a law. */
export type LoopMotion = {
  /** Outputs at the times of the motion, as far as it goes. */
  outputs: Array<Signal>,
  /** What the law moves each control by. */
  controls: Array<Signal>,
  /** Figures of the motion under the law; of a step of a command, how it is followed. */
  metrics: Figures,
  /** Time [s] of the first sample left out, where the motion had outgrown numbers worth having. */
  cut_at: number | null,
};

/** A plane of motion under its law and with its further states, or the reason why it has no analysis. */
export type LoopOutcome = ClosedLoop | {
  /** In one sentence. */
  error: string,
};

export type MatrixFormat = "json" | "csv" | "m";

/** A measure as it reads on an aircraft. */
export type Measure = {
  /** Its key. */
  key: string,
  /** Name in words. */
  name: string,
  /** SI unit of the number; empty for a ratio or a verdict. */
  unit: string,
  /** A number in SI, or the key of a verdict; null where there is nothing to read. */
  value: MeasureValue | null,
  /** The reason why there is nothing to read. */
  absent: string | null,
};

/** A measure that is read at every point of a sweep. */
export type MeasureColumn = {
  /** Its key. */
  key: string,
  /** Name in words. */
  name: string,
  /** SI unit of its numbers; empty for a ratio or a verdict. */
  unit: string,
};

/** A number in SI, or the key of a verdict. */
export type MeasureValue = number | string;

/** A quantity and its unit. */
export type Measured = {
  /** Its key. */
  name: string,
  /** Its SI unit; empty for a ratio, as the throttle's. */
  unit: string,
};

/** A message to the page around the frame. */
export type Message = {
  /** Version of the protocol. */
  eigenwing: 1,
} & ({ "type": "ready",
/** The whole scene, without the `#`. */
link: string,
} | { "type": "height",
/** The height that shows all of the stage at the present width, and not more [CSS pixels]. */
height: number,
} | { "type": "error",
/** What is wrong with it. */
sentence: string,
} | { "type": "scene",
/** The whole scene, without the `#`. */
link: string,
} | { "type": "step-opened",
/** Its heading. */
title: string,
/** The lesson: its key, the path or the name of its file. */
lesson: string,
/** The step, counted from 1. */
step: number,
/** How many steps the lesson has. */
steps: number,
/** How many of them are done: every question has its answer, and every goal is reached. */
done: number,
} | { "type": "answered",
/** The part of the step, counted from 1. */
part: number,
/** The answer. */
answer: unknown,
/** Whether nothing is wrong with it; null where there is nothing to compare it with. */
right: boolean | null,
/** The lesson: its key, the path or the name of its file. */
lesson: string,
/** The step, counted from 1. */
step: number,
/** How many steps the lesson has. */
steps: number,
/** How many of them are done: every question has its answer, and every goal is reached. */
done: number,
} | { "type": "goal-reached",
/** The part of the step, counted from 1. */
part: number,
/** Whether no solution had been shown. */
unaided: boolean,
/** The scene that reached it, without the `#`. */
link: string,
/** The lesson: its key, the path or the name of its file. */
lesson: string,
/** The step, counted from 1. */
step: number,
/** How many steps the lesson has. */
steps: number,
/** How many of them are done: every question has its answer, and every goal is reached. */
done: number,
} | { "type": "report",
/** As a report of the page holds it. */
records: unknown,
});

/** A mode. */
export type Mode = {
  /** Key of the mode. */
  key: ModeKey,
  /** Name of the mode. */
  name: string,
  /** Why, with numbers. */
  reason: string,
  /** Share of the mode in the states that gave it its name, 0 to 1. */
  confidence: number,
  /** Real part σ of its eigenvalue. */
  re: number,
  /** Imaginary part ω ≥ 0 of its eigenvalue; positive stands for the pair σ ± jω. */
  im: number,
  /** `stable`, `neutral` or `unstable`. */
  stability: Stability,
  /** ωₙ, of an oscillation. */
  natural_frequency: number | null,
  /** ζ, negative when it grows; of an oscillation. */
  damping_ratio: number | null,
  /** ω_d, of an oscillation. */
  damped_frequency: number | null,
  /** T, of an oscillation. */
  period: number | null,
  /** t½, of what dies away. */
  time_to_half: number | null,
  /** t₂, of what grows. */
  time_to_double: number | null,
  /** Oscillations until the amplitude has halved or doubled. */
  cycles: number | null,
  /** τ = −1/λ, of a real mode. */
  time_constant: number | null,
  /** Share of each state, adding up to 1. */
  participation: [number, number, number, number],
  /** Right eigenvector of unit length, [real, imaginary] of each state. */
  eigenvector: [[number, number], [number, number], [number, number], [number, number]],
  /** Left eigenvector l of unit length, lᴴ A = λ lᴴ. */
  left_eigenvector: [[number, number], [number, number], [number, number], [number, number]],
  /** Condition number of λ, its greatest movement for a relative change of A: 1 at best, 1e16 at a repeated root. */
  condition: number,
};

export type ModeKey = "short-period" | "short-period-fast-root" | "short-period-slow-root" | "pitch-subsidence" | "pitch-divergence" | "third-oscillatory" | "phugoid" | "phugoid-fast-root" | "phugoid-slow-root" | "speed-subsidence" | "speed-divergence" | "dutch-roll" | "dutch-roll-more-stable-root" | "dutch-roll-less-stable-root" | "sideslip-subsidence" | "directional-divergence" | "coupled-roll-spiral" | "lateral-oscillation" | "roll-subsidence" | "roll-divergence" | "spiral" | "lateral-subsidence" | "lateral-divergence" | "height" | "heading" | "position" | "washout" | "elevator-actuator" | "engine" | "aileron-actuator" | "rudder-actuator" | "feedback-oscillation" | "further-state" | "further-oscillation";

/** Frequency and damping, or a real root. */
export type ModeValue = {
  /** ωₙ. */
  natural_frequency: number,
  /** ζ, where the approximation gives one. */
  damping_ratio: number | null,
} | {
  /** λ. */
  root: number,
};

/** The motion after a disturbance. */
export type Motion = {
  /** The aircraft. */
  aircraft: Aircraft,
  /** Values set on it, SI. */
  set: Record<string, number>,
  /** What of the link can't be used, and a mode that is flown alone where the aircraft without its law hasn't it, in sentences. */
  notices: Array<string>,
  /** `longitudinal` or `lateral`. */
  plane: PlaneName,
  /** Key of the disturbance. */
  disturbance: Disturbance,
  /** Key of its shape; null where it has one of its own. */
  shape: Shape | null,
  /** Name of the mode that is flown alone; null with other disturbances. */
  mode: string | null,
  /** Its key. */
  mode_key: ModeKey | null,
  /** Times of the samples [s]. */
  time: Array<number>,
  /** Inputs at these times, in the sense of their parameters: air is positive where it rises, comes from ahead or moves to the
   * right. None where the aircraft is let go. */
  inputs: Array<Signal>,
  /** Outputs at these times, as changes from the steady flight: those of the plane, by their keys. */
  outputs: Array<Signal>,
  /** Time [s] from which the motion is no small disturbance any more, so that the linear answer is no longer that of the aircraft. */
  small_until: number | null,
  /** The limit that it has passed then, in one sentence; null where it stays small. */
  small_limit: string | null,
  /** Time [s] of the first sample left out, where the motion had outgrown numbers worth having. */
  cut_at: number | null,
  /** Metrics of the motion while it is a small disturbance. */
  figures: Figures,
  /** The parts of the modes in each of the outputs; null where they weren't asked for. */
  split: Array<SplitOutcome> | null,
  /** The same without linearising; null where it wasn't asked for. */
  nonlinear: FlightOutcome | null,
  /** The same linear motion under the law of feedback; null where nothing is fed back. All else is of the aircraft without it. */
  closed_loop: LoopMotion | null,
};

/** Metrics of one output, in its SI unit. */
export type OutputFigures = {
  /** Name of the output. */
  name: string,
  /** Its SI unit; empty for a ratio. */
  unit: string,
  /** Value farthest from zero; null where that is no peak. */
  peak: Peak | null,
  /** Value where the linear model ends while it is still growing, nobody knows how far; null where it has a peak. */
  beyond: number | null,
  /** Value that it goes to after a step; null where it goes to none, or where the linear model ends on the way. */
  steady: number | null,
  /** Time from 10 % to 90 % of the steady value, both for the first time [s]; null too where the linear model ends on the way. */
  rise_time: number | null,
  /** Time after the step from which it stays within 2 % of the steady value [s], likewise. */
  settling_time: number | null,
  /** Overshoot beyond the steady value, as a fraction of it, likewise. */
  overshoot: number | null,
  /** Root mean square of the change over the time watched; in turbulence only. */
  root_mean_square: number | null,
};

/** The level of an aircraft as a whole. */
export type OverallLevel = {
  /** The level in words; null where flight has something in it that no paragraph judges. */
  level: string | null,
  /** Key of the level. */
  level_key: LevelKey | null,
  /** Key of the criterion that governs it. */
  criterion_key: CriterionKey,
  /** Class of MIL-F-8785C that it is judged for. */
  class: AircraftClass,
  /** Category of flight phase that it is judged for. */
  category: FlightPhase,
  /** Keys of the modes that no paragraph judges: those that grow, and oscillations of the aircraft. */
  unjudged: Array<ModeKey>,
  /** The level and what sets it, in one sentence. */
  sentence: string,
};

/** A parameter that can be set on an aircraft. */
export type Parameter = {
  /** Its key, in `set` and in a sweep. */
  key: string,
  /** Name in words. */
  name: string,
  /** Its meaning, in a sentence. */
  meaning: string,
  /** The sign that stabilises, or the effect of a positive or a larger value. */
  sign: string,
  /** SI unit of the numbers below; empty for a ratio. */
  unit: string,
  /** `longitudinal` or `lateral`; null for both. */
  plane: PlaneName | null,
  /** Value on this aircraft. */
  value: number,
  /** Ends of its slider: the physical range. */
  slider: [number, number],
  /** Least and greatest value that is accepted. */
  accepted: [number, number],
};

/** The part of one mode in an output. */
export type Part = {
  /** Name of the mode. */
  mode: string,
  /** Its key. */
  mode_key: ModeKey,
  /** A value at each time. */
  values: Array<number>,
};

/** A value farthest from zero. */
export type Peak = {
  /** The value, with its sign. */
  value: number,
  /** When [s]. */
  time: number,
};

/** The analysis of one plane of motion. */
export type Plane = {
  /** Keys of the states, in the order of the rows and columns. */
  states: [string, string, string, string],
  /** Keys of the inputs, in the order of the columns of B. */
  inputs: [string, string],
  /** State matrix, row by row. */
  a: [[number, number, number, number], [number, number, number, number], [number, number, number, number], [number, number, number, number]],
  /** Input matrix, row by row. */
  b: [[number, number], [number, number], [number, number], [number, number]],
  /** The steady flight. */
  trim: Trim,
  /** All four eigenvalues as [real part, imaginary part], each pair with both, in the order of the modes. */
  eigenvalues: Array<[number, number]>,
  /** The modes, each conjugate pair once. */
  modes: Array<Mode>,
  /** `stable`, `neutral` or `unstable`: that of the worst mode. */
  dynamic_stability: Stability,
  /** Static stability, a verdict of its own. */
  static_stability: StaticStability,
  /** Textbook approximations beside the exact modes. */
  approximations: Array<Approximation>,
  /** Handling qualities after MIL-F-8785C, where the aircraft has a class. */
  levels: Array<Level>,
  /** A and B of all states of the source, where it has more than these four; null otherwise. */
  whole: WholeModel | null,
  /** The same plane under the law of feedback and with all states of its source; null where nothing is fed back and the source has
   * four. All else is of the four states without a law. */
  closed_loop: LoopOutcome | null,
};

/** Eigenvalues of a plane of motion in a file of matrices. */
export type PlaneEigenvalues = {
  /** Key of the plane. */
  plane: string,
  /** Real and imaginary part of each [1/s], of the four states. */
  values: Array<[number, number]>,
  /** The same with the further states that were kept; empty where there are none. */
  with_further: Array<[number, number]>,
};

export type PlaneName = "longitudinal" | "lateral";

/** The analysis of one plane, or the reason why there is none. */
export type PlaneOutcome = Plane | {
  /** In one sentence. */
  error: string,
};

/** A number as it stands in the file, and what it was taken for. */
export type ReadQuantity = {
  /** Line of the file, counted from 1; 0 where it follows from others. */
  line: number,
  /** As it stands there. */
  text: string,
  /** Key of the quantity. */
  key: string,
  /** The quantity in words. */
  meaning: string,
  /** Its value in `unit`. */
  value: number | null,
  /** SI unit; degrees for angles of the trim. */
  unit: string,
};

/** A disturbance, the number of samples, and the extras that are wanted. */
export type ResponseRequest = {
  /** `longitudinal` or `lateral`; by default that of the disturbance, and the aircraft's first where it can be both. */
  plane?: PlaneName,
  /** Key of the disturbance; by default the plane's first, elevator or rudder. Its size is a parameter. */
  disturbance?: Disturbance,
  /** Its shape in time, of those it can have; by default that of the page. */
  shape?: Shape,
  /** Key of the mode that is flown alone, with the disturbance `mode`: under a law one of those; by default the first. Its name and its number are read, too. */
  mode?: string,
  /** Steps between the samples, one less than their number; 600 by default, in turbulence one each 0.05 s. */
  steps?: number,
  /** Whether the same is flown in six degrees of freedom, without linearising; by default only where a link says so. */
  nonlinear?: boolean,
  /** Whether each output is split into the parts of the modes; likewise. */
  split?: boolean,
};

/** A value of a field. */
export type ReviewChoice = {
  /** The value. */
  key: string,
  /** The value in words. */
  words: string,
};

/** Something that looks wrong. */
export type ReviewDoubt = {
  /** Its key. */
  key: string,
  /** Line of the file, counted from 1; 0 where it concerns the whole. */
  line: number,
  /** Whether the aircraft can be used all the same. */
  stops: boolean,
  /** A sentence with the numbers that show it. */
  sentence: string,
  /** Values that mend it, where it is certain what is wrong. */
  remedy: Array<ReviewRemedy>,
};

/** Something that a person can fill in. */
export type ReviewField = {
  /** Its key, by which a value is given. */
  key: string,
  /** What it is. */
  meaning: string,
  /** Unit of its number; empty for a choice or a text. */
  unit: string,
  /** Least plausible value. */
  low: number | null,
  /** Greatest plausible value. */
  high: number | null,
  /** The values that it can have, where they are few. */
  choices: Array<ReviewChoice>,
  /** A value that is likely. */
  suggested: string | null,
  /** Why that one. */
  reason: string | null,
  /** The value that is used at present. */
  value: string | null,
  /** Whether the aircraft waits for it. */
  required: boolean,
};

/** A field and the value that mends something. */
export type ReviewRemedy = {
  /** Key of the field. */
  key: string,
  /** The value. */
  value: string,
};

export type Shape = "step" | "pulse" | "doublet" | "3-2-1-1" | "sine" | "sweep" | "1-cosine";

/** A quantity over time. */
export type Signal = {
  /** Its key, such as `theta`. */
  name: string,
  /** Its SI unit; empty for a ratio. */
  unit: string,
  /** Its values, one a time. */
  values: Array<number>,
};

/** The parts of an output; with `rest` they add up to it. */
export type Split = {
  /** Name of the output. */
  name: string,
  /** Its SI unit; empty for a ratio. */
  unit: string,
  /** The part of each mode, in the order of the modes. */
  parts: Array<Part>,
  /** The rest, which no mode makes: the immediate effect of the input, and the drift of the path. */
  rest: Array<number>,
};

/** An output split into the parts of the modes, or why it has no meaningful split. */
export type SplitOutcome = Split | {
  /** Name of the output. */
  name: string,
  /** In one sentence. */
  error: string,
};

export type Stability = "stable" | "neutral" | "unstable";

export type StabilityKind = "static" | "dynamic";

/** Static stability of a plane. */
export type StaticStability = {
  /** `stable`, `neutral` or `unstable`: of the pitch stiffness, or the worse of those in yaw and roll. */
  verdict: Stability,
  /** det A. */
  determinant: number,
  /** Whether the stiffnesses are derivatives as such; else they are found from A: M_w as if M_u were zero, the others with the
   * product of inertia folded in. */
  plain_derivatives: boolean,
} & ({
  /** M_w, negative is restoring. */
  pitch_stiffness: number,
  /** By how much M_w would have to grow to come to the manoeuvre point. */
  to_manoeuvre_point: number | null,
} | {
  /** N_v, positive is restoring. */
  weathercock_stiffness: number,
  /** L_v, negative is restoring. */
  dihedral_effect: number,
  /** L'v N'r − N'v L'r, positive is a stable spiral in level flight. */
  spiral_condition: number,
});

export type Status = "verified" | "unverified";

/** Early end of a flight. */
export type Stop = {
  /** Time [s]. */
  time: number,
  /** Reason with the time, in one sentence. */
  sentence: string,
};

/** Which aircraft, and what is set on it: one of `aircraft`, `link`, `toml` and `matrices`, or a link with the `toml` that it names. */
export type Subject = {
  /** Key of an aircraft of the list, such as `navion`. */
  aircraft?: string,
  /** Link to a scene, with or without its `#` and the address before that; what else the request says counts above it. */
  link?: string,
  /** Text of an aircraft file; beside a link that of the aircraft which the link names by its key, where it is too long for it. */
  toml?: string,
  /** Text of bare matrices A and B with named states. */
  matrices?: string,
  /** How `matrices` is written; `m` is MATLAB. */
  format?: MatrixFormat,
  /** Name of the text in messages. */
  file?: string,
  /** Values by the keys of the parameters [SI, radians]. */
  set?: { [key in string]: number },
  /** Class of aircraft that levels are judged for; that of the link or of the aircraft's file without one. */
  class?: AircraftClass,
  /** Category of flight phase that levels are judged for. */
  category?: FlightPhase,
};

/** Modes and verdicts along a sweep. */
export type Sweep = {
  /** The aircraft. */
  aircraft: Aircraft,
  /** The unit of every number below, by the name of its field. */
  units: Record<string, string>,
  /** Other values set on it, SI. */
  set: Record<string, number>,
  /** What of the link can't be used, in sentences; none without a link. */
  notices: Array<string>,
  /** Key of the parameter. */
  parameter: string,
  /** Its SI unit: that of `value`, `between` and `at`. */
  unit: string,
  /** The measures that were asked for, with the SI unit of each number, in the order of `measures` at every point. */
  measures: Array<MeasureColumn>,
  /** The points in order. */
  points: Array<SweepPoint>,
  /** Changes of a verdict, with their places. */
  changes: Array<SweepChange>,
};

/** A change of verdict between two neighbouring points. */
export type SweepChange = {
  /** The plane. */
  plane: PlaneName,
  /** `static` or `dynamic`. */
  stability: StabilityKind,
  /** The points before and after it. */
  between: [number, number],
  /** Value of the parameter there, by bisection; the value of one change, should there be several between the two points. */
  at: number,
  /** The verdict before. */
  from: Stability,
  /** The verdict after. */
  to: Stability,
};

/** A mode at one point. */
export type SweepMode = {
  /** Key of the mode. */
  key: ModeKey,
  /** Name of the mode. */
  name: string,
  /** `stable`, `neutral` or `unstable`: whether this mode dies away. */
  stability: Stability,
  /** Real part. */
  re: number,
  /** Imaginary part, not negative. */
  im: number,
  /** ωₙ, of an oscillation. */
  natural_frequency: number | null,
  /** ζ, of an oscillation. */
  damping_ratio: number | null,
};

/** A plane of motion at one point. */
export type SweepPlane = {
  /** `stable`, `neutral` or `unstable`. */
  static_stability: Stability,
  /** Stability of the worst mode. */
  dynamic_stability: Stability,
  /** det A. */
  determinant: number,
  /** The modes. */
  modes: Array<SweepMode>,
};

/** A point of a sweep. */
export type SweepPoint = {
  /** Value of the parameter. */
  value: number,
  /** Longitudinal motion; null where the aircraft has no data of it or the parameter doesn't move it. */
  longitudinal: SweepPlane | null,
  /** Lateral–directional motion, likewise. */
  lateral: SweepPlane | null,
  /** Reason why a plane with data has no modes here. */
  error: string | null,
  /** What the measures read here; null where there is nothing to read. */
  measures: Array<MeasureValue | null>,
};

/** A parameter, and the values that it goes through. */
export type SweepRequest = {
  /** Key of the parameter. */
  parameter: string,
  /** First value [SI]. */
  from: number,
  /** Last value [SI]. */
  to: number,
  /** Number of values, both ends among them. */
  points?: number,
  /** Keys of measures that are read at every point. */
  measures?: Array<string>,
};

/** What was taken along. */
export type TakenAlong = {
  /** The text. */
  text: string,
  /** A name for its file. */
  file: string,
  /** Its media type. */
  media_type: string,
  /** What of the link can't be used, and what of the scene has no place in it, in sentences. */
  notices: Array<string>,
};

export type Target = "python" | "notebook" | "matlab" | "latex" | "toml" | "json" | "jsbsim" | "derivatives" | "poles" | "modes" | "response" | "metrics" | "frequency" | "chart" | "levels" | "poles-figure" | "response-figure" | "frequency-figure" | "chart-figure" | "aircraft-figure" | "page";

/** A transfer function K ∏(s − z) / ∏(s − p). */
export type TransferFunction = {
  /** K, in units of the gain and of s; zero where the input doesn't reach the output. */
  gain: number,
  /** Zeros as [real part, imaginary part], each pair with both. */
  zeros: Array<[number, number]>,
  /** Poles likewise, those of the path over the Earth among them. */
  poles: Array<[number, number]>,
  /** The whole in factors, in SI: `−3 s (s + 0.2) / [(s² + 2·0.1·0.2 s + 0.2²) (s + 4)]`. */
  text: string,
  /** What zeros in the right half-plane do, in one sentence; null where there are none. */
  zeros_on_the_right: string | null,
};

/** A steady flight. */
export type Trim = {
  /** True airspeed V. */
  speed: number,
  /** Angle of attack of the x axis; zero in stability axes. */
  alpha0: number,
  /** Flight-path angle, climbing positive. */
  gamma0: number,
  /** Acceleration of free fall. */
  gravity: number,
};

/** A model with states beside the four, or under a law of feedback. */
export type WholeModel = {
  /** Keys of the states, the four first: `h`, `x`, `psi`, `y`, `elevator` and other controls, `engine`, `other`. */
  states: Array<string>,
  /** State matrix, row by row. */
  a: Array<Array<number>>,
  /** Input matrix, row by row: a control that is a state is commanded. */
  b: Array<[number, number]>,
};
