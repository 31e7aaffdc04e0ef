//! Follows a declaration's file and the tables that it names.

use sim_runtime::{DeclarationFile, Digest};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Condvar, Mutex, PoisonError};
use std::time::{Duration, Instant, SystemTime};

/// How often files are looked at.
const BETWEEN: Duration = Duration::from_millis(5);
/// Files that were changed so short a time ago are compared by what is in them: their time may stay the same.
const FRESH: Duration = Duration::from_millis(200);
/// How long the file may be away or empty, as editors leave it for a moment.
const PATIENCE: Duration = Duration::from_millis(500);
/// The largest table that is compared, in bytes: larger ones are refused.
const LARGEST: u64 = 16 << 20;

/// What there is to do.
pub(super) enum Job {
    /// Read and run this file.
    Run(DeclarationFile),
    /// Say why it cannot be read.
    Missing(String),
}

/// The last change of the files, and how many there were.
#[derive(Default)]
pub(super) struct Changes {
    job: Mutex<Option<Job>>,
    came: Condvar,
    count: AtomicU64,
}

impl Changes {
    /// How many there were: work on an earlier one is to be left when this grows.
    pub(super) fn count(&self) -> u64 {
        self.count.load(Ordering::Relaxed)
    }

    fn add(&self, job: Job) {
        // Counted while it is put: whoever takes it gets the count that belongs to it.
        let mut last = self.job.lock().unwrap_or_else(PoisonError::into_inner);
        *last = Some(job);
        self.count.fetch_add(1, Ordering::Relaxed);
        drop(last);
        self.came.notify_all();
    }

    /// Waits for a change, and gives the last one with its count.
    pub(super) fn wait(&self) -> (Job, u64) {
        let mut job = self.job.lock().unwrap_or_else(PoisonError::into_inner);
        loop {
            match job.take() {
                Some(job) => return (job, self.count()),
                None => job = self.came.wait(job).unwrap_or_else(PoisonError::into_inner),
            }
        }
    }

    /// Looks at the files for ever.
    pub(super) fn follow(&self, path: &Path) -> ! {
        let mut followed = Followed::default();
        loop {
            if let Some(job) = followed.look(path) {
                self.add(job);
            }
            std::thread::sleep(BETWEEN);
        }
    }
}

/// Modification time and size of a file.
type Stamp = Option<(SystemTime, u64)>;

/// A file as it was when it was last looked at.
struct Seen {
    path: PathBuf,
    stamp: Stamp,
    digest: u64,
}

#[derive(Default)]
struct Followed {
    declaration: Stamp,
    digest: Option<u64>,
    tables: Vec<Seen>,
    /// Whether one has changed since the last run.
    tables_changed: bool,
    away_since: Option<Instant>,
    is_told: bool,
}

impl Followed {
    /// What there is to do, if anything has changed.
    fn look(&mut self, path: &Path) -> Option<Job> {
        let stamp = stamp(path);
        // Each table is looked at: two that change together are one change.
        for table in &mut self.tables {
            self.tables_changed |= table.has_changed();
        }
        if stamp == self.declaration && !is_fresh(stamp) && self.away_since.is_none() && !self.tables_changed {
            return None;
        }
        let file = match DeclarationFile::read(path) {
            Ok(file) if file.text().trim().is_empty() => return self.is_away(format!("{} is empty", path.display())),
            Ok(file) => file,
            Err(why) => return self.is_away(why.to_string()),
        };
        let digest = Some(Digest::of(file.text().as_bytes()));
        let tables_changed = std::mem::take(&mut self.tables_changed);
        let is_new = digest != self.digest || self.is_told || tables_changed;
        (self.declaration, self.digest, self.away_since, self.is_told) = (stamp, digest, None, false);
        if !is_new {
            return None;
        }
        let mut paths = file.tables();
        paths.sort();
        paths.dedup();
        if !paths.iter().eq(self.tables.iter().map(|table| &table.path)) {
            self.tables = paths.into_iter().map(Seen::new).collect();
        }
        Some(Job::Run(file))
    }

    /// Says once that the file cannot be read, when it has been so for a while.
    fn is_away(&mut self, why: String) -> Option<Job> {
        let since = *self.away_since.get_or_insert_with(Instant::now);
        let is_due = since.elapsed() > PATIENCE && !self.is_told;
        self.is_told |= is_due;
        is_due.then_some(Job::Missing(why))
    }
}

impl Seen {
    fn new(path: PathBuf) -> Seen {
        Seen { stamp: stamp(&path), digest: digest(&path), path }
    }

    fn has_changed(&mut self) -> bool {
        let now = stamp(&self.path);
        if now == self.stamp && !is_fresh(now) {
            return false;
        }
        let before = self.digest;
        (self.stamp, self.digest) = (now, digest(&self.path));
        self.digest != before
    }
}

fn stamp(path: &Path) -> Stamp {
    let there = path.metadata().ok()?;
    Some((there.modified().ok()?, there.len()))
}

fn is_fresh(stamp: Stamp) -> bool {
    stamp.is_some_and(|(time, _)| time.elapsed().is_ok_and(|age| age < FRESH))
}

/// That of a table's bytes; 0 for what is no table.
fn digest(path: &Path) -> u64 {
    let is_table = path.metadata().is_ok_and(|there| there.is_file() && there.len() <= LARGEST);
    let bytes = if is_table { std::fs::read(path).ok() } else { None };
    bytes.map_or(0, |bytes| Digest::of(&bytes))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    /// What the file says, if there is something to do.
    fn looked(followed: &mut Followed, path: &Path) -> Option<String> {
        match followed.look(path)? {
            Job::Run(file) => Some(file.text().to_owned()),
            Job::Missing(why) => Some(why),
        }
    }

    #[test]
    fn changes_are_seen_and_gaps_are_not() {
        let folder = std::env::temp_dir().join(format!("linkwright-follow-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let path = folder.join("a.mech");
        let mut followed = Followed::default();
        fs::write(&path, "pub A; tables { f from \"f.csv\"; }").unwrap();
        assert!(looked(&mut followed, &path).unwrap().starts_with("pub A"));
        assert_eq!(looked(&mut followed, &path), None);
        // The same text again is no change; another of the same length at once is one.
        fs::write(&path, "pub A; tables { f from \"f.csv\"; }").unwrap();
        assert_eq!(looked(&mut followed, &path), None);
        fs::write(&path, "pub B; tables { f from \"f.csv\"; }").unwrap();
        assert!(looked(&mut followed, &path).unwrap().starts_with("pub B"));
        // A table that comes, and changes.
        for rows in ["0, 0\n", "0, 1\n"] {
            fs::write(folder.join("f.csv"), rows).unwrap();
            assert!(looked(&mut followed, &path).is_some(), "{rows}");
            assert_eq!(looked(&mut followed, &path), None);
        }
        // A table changes while the file is away for a moment, and the same file comes back.
        let text = fs::read(&path).unwrap();
        fs::remove_file(&path).unwrap();
        fs::write(folder.join("f.csv"), "0, 2\n").unwrap();
        assert_eq!(looked(&mut followed, &path), None);
        fs::write(&path, text).unwrap();
        assert!(looked(&mut followed, &path).is_some());
        assert_eq!(looked(&mut followed, &path), None);
        // Away for a moment, empty for a moment, and replaced by another file.
        fs::remove_file(&path).unwrap();
        assert_eq!(looked(&mut followed, &path), None);
        fs::write(&path, "").unwrap();
        assert_eq!(looked(&mut followed, &path), None);
        fs::write(folder.join("new"), "pub C;").unwrap();
        fs::rename(folder.join("new"), &path).unwrap();
        assert_eq!(looked(&mut followed, &path).as_deref(), Some("pub C;"));
        // Away for good.
        fs::remove_file(&path).unwrap();
        assert_eq!(looked(&mut followed, &path), None);
        std::thread::sleep(PATIENCE + Duration::from_millis(50));
        assert!(looked(&mut followed, &path).unwrap().contains("cannot read"));
        assert_eq!(looked(&mut followed, &path), None);
        fs::write(&path, "pub C;").unwrap();
        assert_eq!(looked(&mut followed, &path).as_deref(), Some("pub C;"));
        fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn the_last_change_counts() {
        let changes = Changes::default();
        for text in ["pub A;", "pub B;"] {
            changes.add(Job::Run(DeclarationFile::of(Path::new("a.mech"), text.to_owned())));
        }
        let (job, count) = changes.wait();
        assert!(matches!(job, Job::Run(file) if file.text() == "pub B;"));
        assert_eq!((count, changes.count()), (2, 2));
    }
}
