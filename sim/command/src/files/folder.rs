//! The output folder: locked while a command works for it, and filled when all files are complete, so that earlier
//! files stay until then.
//!
//! Files are first written to a folder within it. The lock is the operating system's, on the folder itself, so a killed
//! process leaves no lock behind. A file that cannot be written is named; if new files would then stand beside earlier
//! ones, they stay aside, in `incomplete`.

use crate::Stop;
use crate::files::identity;
use crate::tell::tell;
use serde_json::{Map, Value};
use sim_output::{WriteError, whole, write_json};
use std::fs::{self, File, TryLockError};
use std::io;
use std::mem;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The subfolder for files until all are written.
const UNFINISHED: &str = ".unfinished";
/// The subfolder where they stay, until the next run, if some could not be written and earlier files would be lost.
const INCOMPLETE: &str = "incomplete";

/// The folder of the running command, for the signal handler, which may run at any time.
static CURRENT: Mutex<Current> = Mutex::new(Current::Nothing);

/// What a signal finds.
enum Current {
    /// No folder: nothing is to be written.
    Nothing,
    /// A folder that is being written to.
    Held(Folder),
    /// All files are in their places.
    Filled(Ended),
}

/// What is said if a signal ends the program.
#[derive(Clone, Default)]
pub(crate) struct Ended {
    /// The files in their final places.
    pub(crate) names: Vec<String>,
    /// Why the work itself failed, by the summary, and why files are missing.
    pub(crate) failures: Vec<String>,
}

/// A locked folder, with the files written for it.
struct Folder {
    directory: PathBuf,
    /// Whether it was made for this command.
    is_new: bool,
    /// The operating system's lock, which ends with the process.
    _lock: Option<File>,
    /// The files that are whole.
    names: Vec<String>,
    /// The summary of the run, which identifies the other files.
    summary: Option<(String, Value)>,
    /// The files that such commands write, and those of the run before.
    earlier: Vec<String>,
}

/// The outcome.
#[derive(Default)]
pub(crate) struct Filled {
    /// The files in their final places.
    pub(crate) names: Vec<String>,
    /// Why others are not.
    pub(crate) failures: Vec<WriteError>,
    /// The folder with all of them instead, because some could not be written.
    pub(crate) aside: Option<PathBuf>,
}

/// Creates and locks a folder, and gives the subfolder to write files to.
pub(crate) fn hold(directory: &Path, mut earlier: Vec<String>) -> Result<PathBuf, Stop> {
    let fail = |path: &Path, why: io::Error| Stop::from(WriteError::new(path, why));
    let is_new = !directory.exists();
    fs::create_dir_all(directory).map_err(|why| fail(directory, why))?;
    let lock = lock(directory)?;
    let unfinished = directory.join(UNFINISHED);
    // The remains of a run that was killed.
    let _ = fs::remove_dir_all(&unfinished);
    fs::create_dir(&unfinished).map_err(|why| fail(&unfinished, why))?;
    earlier.extend(identity::listed(directory));
    let folder =
        Folder { directory: directory.to_owned(), is_new, _lock: lock, names: Vec::new(), summary: None, earlier };
    *current() = Current::Held(folder);
    Ok(unfinished)
}

fn current() -> MutexGuard<'static, Current> {
    CURRENT.lock().unwrap_or_else(PoisonError::into_inner)
}

fn lock(directory: &Path) -> Result<Option<File>, Stop> {
    let lock = || {
        let folder = File::open(directory).map_err(TryLockError::Error)?;
        folder.try_lock().map(|()| folder)
    };
    match lock() {
        Ok(folder) => Ok(Some(folder)),
        Err(TryLockError::WouldBlock) => Err(Stop::Failed(anyhow::anyhow!(
            "another run writes to {}: wait until it has ended, or give another folder with `--out`",
            directory.display()
        ))),
        Err(TryLockError::Error(why)) => {
            tell!(
                "warning: {} cannot be locked ({why}): make sure that nothing else writes there",
                directory.display()
            );
            Ok(None)
        }
    }
}

/// Records a complete file.
pub(crate) fn add(name: &str) {
    if let Current::Held(folder) = &mut *current() {
        folder.names.push(name.to_owned());
    }
}

/// Keeps the summary under this name. From then on a signal keeps the complete files.
pub(crate) fn tell(name: &str, summary: Value) {
    if let Current::Held(folder) = &mut *current() {
        folder.summary = Some((name.to_owned(), summary));
    }
}

/// Whether a command still has to write its tables, or its summary.
pub(crate) fn is_awaited() -> bool {
    matches!(&*current(), Current::Held(folder) if folder.summary.is_none())
}

/// Moves all files to their places, and removes earlier ones without a successor. If `is_short` of some, or if some
/// cannot be placed, puts them aside if there are earlier files.
pub(crate) fn fill(is_short: bool) -> Filled {
    let mut current = current();
    match mem::replace(&mut *current, Current::Nothing) {
        Current::Held(folder) => {
            let failed = folder.failed();
            let filled = folder.fill(is_short);
            *current = Current::Filled(filled.ended(failed));
            filled
        }
        _ => Filled::default(),
    }
}

/// Ends with the complete files if the tables are among them, otherwise with none.
pub(crate) fn end() -> Ended {
    let mut current = current();
    let ended = match mem::replace(&mut *current, Current::Nothing) {
        Current::Held(folder) if folder.summary.is_some() => {
            let failed = folder.failed();
            folder.fill(false).ended(failed)
        }
        Current::Filled(ended) => ended,
        _ => Ended::default(),
    };
    // Nothing else is written from here on: the process ends.
    mem::forget(current);
    ended
}

impl Filled {
    fn ended(&self, failed: Option<String>) -> Ended {
        let failures = failed.into_iter().chain(self.failures.iter().map(ToString::to_string));
        Ended { names: self.names.clone(), failures: failures.collect() }
    }
}

impl Folder {
    fn unfinished(&self) -> PathBuf {
        self.directory.join(UNFINISHED)
    }

    /// Why the work failed, as its summary says.
    fn failed(&self) -> Option<String> {
        let (_, summary) = self.summary.as_ref()?;
        Some(summary.get("failure")?.as_str()?.to_owned())
    }

    fn fill(mut self, is_short: bool) -> Filled {
        let mut filled = Filled::default();
        let told_by = self.summary.as_ref().map_or(String::new(), |(name, _)| name.clone());
        if let Err(failure) = self.write_summary() {
            filled.failures.push(failure);
        }
        // Targets that are not files, such as devices, are written first: they cannot be rolled back.
        let names = mem::take(&mut self.names);
        let (files, others): (Vec<String>, Vec<String>) = names.into_iter().partition(|name| self.is_file(name));
        others.iter().for_each(|name| self.place(name, &mut filled));
        if (is_short || !filled.failures.is_empty()) && self.has_earlier() {
            return self.put_aside(filled);
        }
        self.earlier.retain(|name| !files.contains(name) && !others.contains(name));
        // The summary, which identifies the others, comes last.
        let (last, files): (Vec<String>, Vec<String>) = files.into_iter().partition(|name| *name == told_by);
        files.iter().for_each(|name| self.place(name, &mut filled));
        self.earlier.iter().filter(|name| self.is_file(name)).for_each(|name| self.remove(name, &mut filled));
        last.iter().for_each(|name| self.place(name, &mut filled));
        let _ = fs::remove_dir_all(self.directory.join(INCOMPLETE));
        filled
    }

    /// Writes the summary, with the digests of all other files.
    fn write_summary(&mut self) -> Result<(), WriteError> {
        let Some((name, mut summary)) = self.summary.take() else { return Ok(()) };
        let unfinished = self.unfinished();
        let others = self.names.iter().filter(|name| !identity::NAMED.contains(&name.as_str()));
        let digests = others.filter_map(|name| {
            let digest = identity::digest(&unfinished.join(name)).ok()?;
            Some((name.clone(), Value::from(digest)))
        });
        summary["digests"] = digests.collect::<Map<_, _>>().into();
        write_json(&summary, &unfinished.join(&name)).map_err(|failure| self.in_place(failure))?;
        self.names.push(name);
        Ok(())
    }

    /// Whether there is a file of this name, or nothing.
    fn is_file(&self, name: &str) -> bool {
        fs::symlink_metadata(self.directory.join(name)).map_or(true, |there| there.is_file())
    }

    fn has_earlier(&self) -> bool {
        let is_there =
            |name: &String| fs::symlink_metadata(self.directory.join(name)).is_ok_and(|there| there.is_file());
        self.earlier.iter().any(is_there)
    }

    fn place(&self, name: &str, filled: &mut Filled) {
        let (from, to) = (self.unfinished().join(name), self.directory.join(name));
        let placed = match self.is_file(name) {
            true => fs::rename(&from, &to),
            // Through links, and into targets that are not files.
            false => whole(&to, |file| io::copy(&mut File::open(&from)?, file).map(|_| ())),
        };
        match placed {
            Ok(()) => filled.names.push(name.to_owned()),
            Err(why) => filled.failures.push(WriteError::new(&to, why)),
        }
    }

    fn remove(&self, name: &str, filled: &mut Filled) {
        let path = self.directory.join(name);
        match fs::remove_file(&path) {
            Err(why) if why.kind() != io::ErrorKind::NotFound => filled.failures.push(WriteError::new(&path, why)),
            _ => {}
        }
    }

    fn put_aside(&self, mut filled: Filled) -> Filled {
        let aside = self.directory.join(INCOMPLETE);
        let _ = fs::remove_dir_all(&aside);
        match fs::rename(self.unfinished(), &aside) {
            Ok(()) => filled.aside = Some(aside),
            Err(why) => filled.failures.push(WriteError::new(&aside, why)),
        }
        filled
    }

    /// A failure to write in the subfolder, reported with the file's final place.
    fn in_place(&self, failure: WriteError) -> WriteError {
        match failure.path.strip_prefix(self.unfinished()) {
            Ok(name) => WriteError { path: self.directory.join(name), ..failure },
            Err(_) => failure,
        }
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(self.unfinished());
        if self.is_new {
            // Only if it is empty.
            let _ = fs::remove_dir(&self.directory);
        }
    }
}
