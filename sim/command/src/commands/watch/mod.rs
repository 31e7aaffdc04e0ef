//! `sim watch`: a local page that follows a file.

mod board;
mod files;
mod live;
mod request;
mod server;

use crate::arguments::{Voice, WatchArguments};
use crate::chosen::any_file;
use crate::{Stop, print, signals};
use board::Board;
use files::Changes;
use request::Gate;
use serde_json::json;
use server::{Server, secret};
use std::io::ErrorKind;
use std::net::{Ipv4Addr, TcpListener};
use std::sync::Arc;

/// Serves the report of a file, and follows its changes until it is interrupted.
pub(crate) fn watch(arguments: &WatchArguments, voice: Voice) -> Result<(), Stop> {
    let word = &arguments.model;
    let Some((path, name)) = any_file(word) else {
        let why = format!(
            "`{word}` is no file, and there is nothing to follow: `new --file {word}.mech --from {word}` writes a mechanism \
             that `list` shows to a file, for `watch {word}.mech`"
        );
        return Err(Stop::Usage(why));
    };
    if !path.is_file() {
        return Err(Stop::Failed(anyhow::anyhow!(
            "{} is no file: `new --file {}` writes a first one",
            path.display(),
            path.display()
        )));
    }
    let listener = listen(arguments.port)?;
    let gate = Gate::new(listener.local_addr()?.port(), secret()?);
    signals::end_well();
    let address = gate.address();
    print(&match voice.json {
        true => format!("{}\n", json!({ "file": path, "address": address })),
        false => format!("{address}\nfollows {} and its tables until Ctrl-C\n", path.display()),
    })?;
    let board = Arc::new(Board::new(live::first_page()?));
    let changes = Arc::new(Changes::default());
    let server = Arc::new(Server::new(gate, Arc::clone(&board)));
    std::thread::spawn(move || server.serve(&listener));
    std::thread::spawn({
        let (changes, path) = (Arc::clone(&changes), path.clone());
        move || changes.follow(&path)
    });
    live::follow(&path, name, &arguments.as_of_run(), &changes, &board)
}

/// Binds to this computer alone.
fn listen(port: u16) -> Result<TcpListener, Stop> {
    TcpListener::bind((Ipv4Addr::LOCALHOST, port)).map_err(|why| match why.kind() {
        ErrorKind::AddrInUse => Stop::Failed(anyhow::anyhow!(
            "port {port} of 127.0.0.1 is taken by another program: choose another with --port, or leave it out, and the system \
             chooses one that is free"
        )),
        _ => Stop::Failed(anyhow::anyhow!("cannot listen on port {port} of 127.0.0.1: {why}")),
    })
}
