//! What faults leave in a folder of results: kills, two runs at once, full disks.

use crate::Random;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

/// Two runs that write files of the same names, and what is in them.
pub struct Faults {
    program: PathBuf,
    place: PathBuf,
    references: [Vec<(String, Vec<u8>)>; 2],
    /// How long a run takes.
    duration: Duration,
}

/// How many folders were not as they should be.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Count {
    /// Folders looked at.
    pub folders: usize,
    /// With a file of neither run.
    pub torn: usize,
    /// With files of both, and a command that reads it nevertheless; or refused though all are of one.
    pub mixed: usize,
    /// Without a file that was there before.
    pub lost: usize,
    /// Into which the next run did not succeed, or that keeps what the fault has left.
    pub unusable: usize,
    /// With files of both runs, which is not wrong in itself.
    pub refused: usize,
}

impl Count {
    /// Whether nothing was wrong.
    pub fn is_clean(&self) -> bool {
        [self.torn, self.mixed, self.lost, self.unusable] == [0; 4]
    }
}

const RUNS: [&[&str]; 2] = [&["--t-end", "0.2", "--rows", "150"], &["--t-end", "0.3", "--rows", "200"]];
const SHARED: [&str; 6] = ["quick-return", "--format", "csv,jsonl,npz", "--size", "320x240", "--quiet"];

impl Faults {
    /// By a program that has the command line and `quick-return`, in a folder of its own.
    ///
    /// # Errors
    /// If a file cannot be read or written, or a sound run fails.
    pub fn new(program: &Path, place: &Path) -> std::io::Result<Faults> {
        let _ = fs::remove_dir_all(place);
        fs::create_dir_all(place)?;
        let (program, place) = (program.to_owned(), place.to_owned());
        let mut faults = Faults { program, place, references: [Vec::new(), Vec::new()], duration: Duration::ZERO };
        for which in [0, 1] {
            let folder = faults.place.join(format!("run-{which}"));
            let clock = Instant::now();
            faults.fill(&folder, which)?;
            faults.duration = clock.elapsed();
            faults.references[which] = read(&folder)?;
        }
        Ok(faults)
    }

    fn command(&self, folder: &Path, which: usize) -> Command {
        let mut command = Command::new(&self.program);
        command.arg("run").args(SHARED).args(RUNS[which]).arg("--out").arg(folder);
        command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped());
        command
    }

    fn fill(&self, folder: &Path, which: usize) -> std::io::Result<()> {
        let output = self.command(folder, which).output()?;
        match output.status.success() {
            true => Ok(()),
            false => Err(std::io::Error::other(String::from_utf8_lossy(&output.stderr).into_owned())),
        }
    }

    /// Kills this many runs, each in a folder with the results of another: half of them at any time, half where they move
    /// their files.
    ///
    /// # Errors
    /// As [`Faults::new`].
    pub fn kills(&self, count: usize, seed: u64) -> std::io::Result<Count> {
        let (folder, mut random, mut found) = (self.place.join("killed"), Random(seed), Count::default());
        for kill in 0..count {
            self.fill(&folder, 0)?;
            let mut child = self.command(&folder, 1).spawn()?;
            match kill % 2 {
                0 => std::thread::sleep(self.duration.mul_f64(random.between(0.0, 1.2))),
                _ => wait_for(&folder.join(".unfinished/timing.json"), &mut child, random.between(0.0, 5e-3)),
            }
            child.kill()?;
            child.wait()?;
            self.look(&folder, &mut found)?;
            let is_used = self.fill(&folder, 1).is_ok() && self.is_one_run(&folder, 1)?;
            found.unusable += usize::from(!is_used);
        }
        Ok(found)
    }

    /// Starts this many pairs of runs into one folder, every other time where there are results already.
    ///
    /// # Errors
    /// As [`Faults::new`].
    pub fn pairs(&self, count: usize) -> std::io::Result<Count> {
        let (folder, mut found) = (self.place.join("shared"), Count::default());
        for pair in 0..count {
            if pair % 2 == 0 {
                let _ = fs::remove_dir_all(&folder);
            }
            let children = [0, 1].map(|which| self.command(&folder, which).spawn());
            let [one, other]: [std::io::Result<Output>; 2] = children.map(|child| child?.wait_with_output());
            let outputs = [one?, other?];
            let is_told = |output: &Output| {
                let said = String::from_utf8_lossy(&output.stderr);
                output.status.success() || said.contains("another run writes to")
            };
            self.look(&folder, &mut found)?;
            let is_whole = [0, 1].map(|which| Ok(outputs[which].status.success() && self.is_one_run(&folder, which)?));
            let [one, other]: [std::io::Result<bool>; 2] = is_whole;
            found.unusable += usize::from(!(one? || other?) || !outputs.iter().all(is_told));
        }
        Ok(found)
    }

    /// Runs where no file may be longer than a limit, once for each file a little below its length: in a folder with results,
    /// and in an empty one.
    ///
    /// # Errors
    /// As [`Faults::new`].
    pub fn full_disks(&self, every: usize) -> std::io::Result<Count> {
        let (folder, mut found) = (self.place.join("full"), Count::default());
        for (_, bytes) in self.references[1].iter().step_by(every) {
            // In units of 512 bytes, of which the limit is a whole number.
            let limit = (bytes.len() - 1) / 512;
            for has_earlier in [true, false] {
                let _ = fs::remove_dir_all(&folder);
                if has_earlier {
                    self.fill(&folder, 0)?;
                }
                let sound = self.command(&folder, 1);
                let mut limited = Command::new("sh");
                // Where the signal is ignored, writing beyond the limit is an error, as on a full disk.
                limited.args(["-c", "trap '' XFSZ; ulimit -f $0; exec \"$@\"", &limit.to_string()]);
                limited.arg(sound.get_program()).args(sound.get_args()).stdout(Stdio::null());
                let output = limited.output()?;
                let said = String::from_utf8_lossy(&output.stderr).into_owned();
                let is_told = output.status.code() == Some(1) && said.contains("cannot write");
                match has_earlier {
                    true => self.look(&folder, &mut found)?,
                    false => found.torn += usize::from(self.is_torn_alone(&folder)?),
                }
                found.unusable +=
                    usize::from(!is_told || self.fill(&folder, 1).is_err() || !self.is_one_run(&folder, 1)?);
            }
        }
        Ok(found)
    }

    /// What is in a folder in which there were results before.
    fn look(&self, folder: &Path, found: &mut Count) -> std::io::Result<()> {
        let owners = self.owners(folder)?;
        found.folders += 1;
        found.torn += usize::from(owners.contains(&[false; 2]));
        let is_one = [0, 1].iter().any(|which| owners.iter().all(|owner| owner[*which]));
        let is_refused =
            self.readers(folder).iter().map(|words| self.refuses(words)).collect::<std::io::Result<Vec<_>>>()?;
        found.mixed += usize::from(is_refused.contains(&is_one));
        found.refused += usize::from(!is_one);
        let is_there = |name: &String| folder.join(name).is_file();
        found.lost += usize::from(!self.references[0].iter().all(|(name, _)| is_there(name)));
        Ok(())
    }

    /// Whether a file is not that of the second run, where that run alone has written, but not all of its files: its summary
    /// lists those that it has.
    fn is_torn_alone(&self, folder: &Path) -> std::io::Result<bool> {
        if !folder.exists() {
            return Ok(false);
        }
        let files = read(folder)?.into_iter().map(|(name, _)| name);
        let owners = self.owners(folder)?;
        let is_torn = files.zip(&owners).any(|(name, owner)| !owner[1] && name != "summary.json");
        Ok(is_torn || self.readers(folder).iter().any(|words| self.refuses(words).unwrap_or(true)))
    }

    /// The commands that read a folder.
    fn readers(&self, folder: &Path) -> [Vec<String>; 3] {
        let text = |path: PathBuf| path.to_string_lossy().into_owned();
        let (run, other) = (text(folder.to_owned()), text(self.place.join("run-0")));
        let (plot, compared) = (text(self.place.join("plot")), text(self.place.join("compared")));
        let again = text(self.place.join("again"));
        let words = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect();
        [
            words(&["plot", &run, "x6", "--out", &plot, "--size", "320x240"]),
            words(&["compare", &run, &other, "--quantity", "x6", "--out", &compared, "--size", "320x240"]),
            words(&["run", &text(folder.join("run.json")), "--no-figures", "--no-report", "--out", &again]),
        ]
    }

    fn refuses(&self, words: &[String]) -> std::io::Result<bool> {
        let output = Command::new(&self.program).args(words).stdout(Stdio::null()).output()?;
        Ok(String::from_utf8_lossy(&output.stderr).contains("are not of one run"))
    }

    /// Whether all files of a run are there, and no others.
    fn is_one_run(&self, folder: &Path, which: usize) -> std::io::Result<bool> {
        let names = fs::read_dir(folder)?.count();
        Ok(names == self.references[which].len() && self.owners(folder)?.iter().all(|owner| owner[which]))
    }

    /// For each file in a folder, whether it is that of either run. Wall times differ: they are known by the run that they name.
    fn owners(&self, folder: &Path) -> std::io::Result<Vec<[bool; 2]>> {
        let run = |bytes: &[u8]| {
            let value = serde_json::from_slice::<serde_json::Value>(bytes).ok()?;
            value.get("run").cloned()
        };
        let is_of = |which: usize, name: &str, bytes: &[u8]| {
            let mut known = self.references[which].iter().filter(|(known, _)| known == name);
            known.any(|(_, known)| match name {
                "timing.json" => run(known).is_some() && run(known) == run(bytes),
                _ => known == bytes,
            })
        };
        let files = read(folder)?;
        Ok(files.iter().map(|(name, bytes)| [0, 1].map(|which| is_of(which, name, bytes))).collect())
    }
}

/// The files of a folder that stand under names of their own.
fn read(folder: &Path) -> std::io::Result<Vec<(String, Vec<u8>)>> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if path.is_file() && !name.starts_with('.') {
            files.push((name, fs::read(&path)?));
        }
    }
    files.sort();
    Ok(files)
}

/// Waits until a file is there, and a little longer; or until the process has ended.
fn wait_for(path: &Path, child: &mut Child, longer: f64) {
    while !path.exists() && child.try_wait().is_ok_and(|ended| ended.is_none()) {
        std::thread::sleep(Duration::from_micros(50));
    }
    let clock = Instant::now();
    while clock.elapsed().as_secs_f64() < longer {
        std::hint::spin_loop();
    }
}
