//! Faults while files are written: a few of each; `cargo run --release -p tests --bin figures -- numbers` takes hundreds.

use crate::fresh;
use std::path::Path;
use tests::faults::Faults;

#[test]
fn what_faults_leave_is_whole_and_of_one_run() {
    let faults = Faults::new(Path::new(env!("CARGO_BIN_EXE_failing")), &fresh("faults")).unwrap();
    for (what, found) in [
        ("kills", faults.kills(6, 1).unwrap()),
        ("pairs", faults.pairs(3).unwrap()),
        #[cfg(unix)]
        ("full disks", faults.full_disks(6).unwrap()),
    ] {
        println!("{what}: {found:?}");
        assert!(found.is_clean(), "{what}: {found:?}");
    }
}
