//! The exported scripts run in the programs that they are for, and come to our own numbers: each asserts so itself, to 1e-8.
//!
//! `cargo xtask test` installs these programs and names them in the environment: `EIGENWING_PYTHON`, a Python with python-control and
//! matplotlib, and `EIGENWING_OCTAVE`, GNU Octave with its package control.

use std::path::PathBuf;
use std::process::{Command, Stdio};

use eigenwing::content::FILES;
use eigenwing::export::{DisturbanceRequest, Source, Subject, Target, take_along};
use eigenwing::key::Keyed as _;

/// Every disturbance and shape, and what is shown of it in each of the views.
const SCENES: [&str; 30] = [
    "v=1&ac=navion&lon.shape=pulse&time=37.3",
    "v=1&ac=navion&lon.source=throttle&lon.shape=doublet&lon.show=u.alpha.q.theta.gamma.nz.h.x.w",
    "v=1&ac=b747-fc9&lon.shape=3-2-1-1&part=1.7&time=123.4",
    "v=1&ac=navion&lon.shape=sine&frequency=2.3&lasting=17&lon.show=u.nz.h",
    "v=1&ac=x15&lon.shape=sweep&time=60&lon.show=alpha.nz.w",
    "v=1&ac=navion&lon.source=vertical-gust&lon.show=u.alpha.nz.h&elevator=2",
    "v=1&ac=navion&lon.source=vertical-gust&lon.gust=step&lon.show=u.alpha.nz",
    "v=1&ac=a4d&lon.source=head-gust&lon.gust=sine&lon.show=u.alpha.nz.h&times=1.5",
    "v=1&ac=navion&lon.source=turbulence&seed=4&time=20&lon.show=u.alpha.nz.h",
    "v=1&ac=c47&lon.source=release&from_q=4",
    "v=1&ac=b747-approach&lon.source=mode&lon.mode=phugoid&lon.show=u.theta.h.x",
    "v=1&ac=navion&cm_alpha=0.5&time=30",
    "v=1&ac=navion&tab=phase&lon.phase=alpha.q.u.theta",
    "v=1&ac=navion&tab=frequency&lon.source=vertical-gust&lon.frequency_of=nz",
    "v=1&ac=navion&tab=frequency&lon.frequency_of=h",
    "v=1&ac=navion&plane=lateral&lat.source=aileron&lat.shape=doublet&part=1.1&lat.show=beta.p.r.phi.psi.ny.y.v",
    "v=1&ac=b747-fc9&plane=lateral&lat.source=side-gust&lat.show=beta.phi.ny.y",
    "v=1&ac=nt33a&plane=lateral&lat.source=turbulence&time=12&lat.show=beta.ny.y",
    "v=1&ac=x15&plane=lateral&lat.source=mode&lat.mode=2&lat.show=beta.phi.psi.y",
    "v=1&ac=citation&plane=lateral&lat.source=release&tab=phase",
    "v=1&ac=navion&plane=lateral&tab=frequency&lat.source=side-gust&lat.frequency_of=psi",
    "v=1&ac=lesson-printed&a_qw=-0.2&tab=metrics",
    "v=1&ac=b747-fc9&plane=lateral&k.r_dr=1.5&washout=3&actuator=0.1",
    "v=1&ac=navion&notation=alpha-beta&lon.shape=doublet&lon.show=u.alpha.q.theta.gamma.nz.h.x.w",
    "v=1&ac=b747-approach&notation=alpha-beta&lon.source=vertical-gust&lon.show=u.alpha.nz.h",
    "v=1&ac=navion&notation=alpha-beta&tab=frequency&lon.frequency_of=alpha",
    "v=1&ac=citation&notation=alpha-beta&plane=lateral&lat.source=release&lat.show=beta.p.r.phi.psi.ny.y.v",
    "v=1&ac=navion&notation=alpha-beta&plane=lateral&tab=frequency&lat.source=side-gust&lat.frequency_of=beta",
    "v=1&ac=b747-fc9&notation=alpha-beta&plane=lateral&k.r_dr=1.5&washout=3&actuator=0.1",
    "v=1&ac=navion&k.q_de=0.3&k.h_de=0.002&engine=1&k.u_dt=0.01&tab=frequency",
];

/// The scripts of all these scenes and of every aircraft as it opens, in both planes, as files of a folder.
fn scripts(target: Target) -> Vec<PathBuf> {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(target.key());
    std::fs::create_dir_all(&folder).expect("a test may write in its folder");
    let listed = FILES.iter().filter_map(|(file, _)| file.strip_suffix(".toml"));
    let of_aircraft =
        listed.flat_map(|key| ["", "&plane=lateral"].map(|plane| format!("v=1&ac={key}{plane}")));
    let links = SCENES.iter().map(|link| (*link).to_owned()).chain(of_aircraft);
    let mut paths = Vec::new();
    for (number, link) in links.enumerate() {
        let source = Source::Link(link.clone());
        let scene = Subject { source, ..Subject::listed("") }.scene().expect("a scene");
        if !scene.notices.is_empty() {
            assert!(link.contains("ac=lesson") && link.ends_with("lateral"), "{link}: {:?}", scene.notices);
            continue;
        }
        let taken = take_along(&scene, target.key(), &DisturbanceRequest::default()).expect("a script");
        let path = folder.join(format!("scene_{number}.{}", target.form().0));
        std::fs::write(&path, taken.text).expect("a test may write in its folder");
        paths.push(path);
    }
    assert!(paths.len() > 50, "{}", paths.len());
    paths
}

/// Runs a program on a text that runs all scripts, and counts what they say.
fn run(program: &str, variable: &str, arguments: &[&str], all: &str, count: usize) {
    let program = std::env::var_os(variable).unwrap_or_else(|| {
        panic!("{variable} names no {program}: `cargo xtask test` installs it and runs this test")
    });
    let output = Command::new(program)
        .args(arguments)
        .arg(all)
        .env("MPLBACKEND", "Agg")
        .stdin(Stdio::null())
        .output()
        .expect("it starts");
    let [said, complained] =
        [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
    let last = |text: &str| {
        text.lines().rev().take(30).collect::<Vec<_>>().into_iter().rev().collect::<Vec<_>>().join("\n")
    };
    assert!(output.status.success(), "{}\n{}", last(&said), last(&complained));
    assert_eq!(said.matches("is that of Eigenwing at").count(), count, "{}", last(&said));
    assert_eq!(said.matches(" 0 times").count(), 0, "a script that compares nothing");
}

#[test]
#[ignore = "needs python-control: cargo xtask test installs it and runs this"]
fn python_scripts_come_to_our_numbers() {
    let paths = scripts(Target::Python);
    let quoted: Vec<String> = paths.iter().map(|path| format!("r\"{}\"", path.display())).collect();
    let all = format!(
        "import runpy, warnings, matplotlib.pyplot as plt\nwarnings.simplefilter('ignore')\nfor path in [{}]:\n    \
         print(path, flush=True)\n    runpy.run_path(path)\n    plt.close('all')\n",
        quoted.join(", ")
    );
    run("Python", "EIGENWING_PYTHON", &["-c"], &all, paths.len());
}

#[test]
#[ignore = "needs GNU Octave with control: cargo xtask test installs it and runs this"]
fn matlab_scripts_come_to_our_numbers_in_octave() {
    let paths = scripts(Target::Matlab);
    let one = |path: &PathBuf| format!("disp('{0}'); source('{0}'); clear all; close all;", path.display());
    let all: String = paths.iter().map(one).collect();
    run(
        "Octave",
        "EIGENWING_OCTAVE",
        &["--no-gui", "--no-init-file", "--quiet", "--eval"],
        &all,
        paths.len(),
    );
}
