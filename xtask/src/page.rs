//! The page, built by Trunk: into dist/, or served.

use std::net::{IpAddr, SocketAddr, TcpListener, TcpStream};
use std::process::Command;
use std::thread;
use std::time::Duration;

use anyhow::{Context as _, Result, bail};

use crate::compress;
use crate::crate_sizes;
use crate::offline;
use crate::packages;
use crate::process;
use crate::project::Project;
use crate::tools::{self, Tool};

/// Tells Trunk's hook with which wasm-opt to make the program smaller; without it the page is built a minute faster, to be looked at.
pub const WASM_OPT: &str = "EIGENWING_WASM_OPT";

/// Builds the release page into dist/, as it goes to a host: kept by browsers for when there is no network, and compressed.
pub fn build(project: &Project) -> Result<()> {
    println!("Building the page (a few minutes the first time)");
    let mut trunk = trunk(project)?;
    if let Some(wasm_opt) = packages::wasm_opt(project)? {
        trunk.env(WASM_OPT, wasm_opt);
    }
    process::run(trunk.args(["build", "--release", "--offline"]))?;
    let dist = project.dist();
    offline::write(project, &dist)?;
    compress::write(&dist)?;
    println!("The page is in {}", dist.display());
    crate_sizes::print(project)
}

/// Builds the release page and serves it until interrupted.
pub fn serve(project: &Project, address: IpAddr, port: u16) -> Result<()> {
    let socket = SocketAddr::new(address, port);
    // Before minutes of building, not after them.
    if let Err(error) = TcpListener::bind(socket) {
        bail!("cannot serve on {socket}: {error}; choose another port with --port");
    }
    // A page that doesn't build is an error here; Trunk's server would go on without it.
    process::run(trunk(project)?.args(["build", "--release", "--offline"]))?;

    let mut server = trunk(project)?
        .args(["serve", "--release", "--offline", "--no-autoreload"])
        .args(["--address", &address.to_string()])
        .args(["--port", &port.to_string()])
        .spawn()
        .context("cannot run `trunk serve`")?;
    loop {
        if let Some(status) = server.try_wait()? {
            bail!("`trunk serve` ended ({status})");
        }
        if TcpStream::connect_timeout(&local(socket), Duration::from_secs(1)).is_ok() {
            break;
        }
        thread::sleep(Duration::from_millis(100));
    }
    println!("\n    Eigenwing is at http://{}/\n    Ctrl+C stops it.\n", local(socket));
    let status = server.wait()?;
    if !status.success() {
        bail!("`trunk serve` ended ({status})");
    }
    Ok(())
}

/// Trunk with everything it needs, so that it has nothing to download.
fn trunk(project: &Project) -> Result<Command> {
    tools::add_wasm_target(project)?;
    let trunk = Tool::trunk().installed(project)?;
    let wasm_bindgen = Tool::wasm_bindgen(project)?.installed(project)?;
    let mut command = Command::new(trunk.join("trunk"));
    command.current_dir(&project.root).env("PATH", tools::path_with(vec![trunk, wasm_bindgen])?);
    // Trunk reads NO_COLOR as a truth value and refuses the customary 1.
    if std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty()) {
        command.env("NO_COLOR", "true");
    }
    Ok(command)
}

/// An address at which this machine reaches another, which may stand for all of them.
fn local(socket: SocketAddr) -> SocketAddr {
    match socket.ip() {
        IpAddr::V4(ip) if ip.is_unspecified() => ([127, 0, 0, 1], socket.port()).into(),
        IpAddr::V6(ip) if ip.is_unspecified() => ([0, 0, 0, 0, 0, 0, 0, 1], socket.port()).into(),
        _ => socket,
    }
}
