//! Files that are whole or absent: each is written beside its place, flushed and renamed.

use std::fs::{self, File};
use std::io::{Error, Write};
use std::path::{Path, PathBuf};

/// Writes a file under another name beside its place, flushes it to the disk and renames it: readers see either the old
/// file or the complete new one, and a failure leaves nothing behind. Links are followed; targets that are not files,
/// such as devices, are written directly.
///
/// # Errors
/// The errors of `write`, and if the file cannot be made, flushed or renamed.
pub fn whole<E: From<Error>>(path: &Path, write: impl FnOnce(&mut File) -> Result<(), E>) -> Result<(), E> {
    let place = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    if fs::metadata(&place).is_ok_and(|there| !there.is_file()) {
        return write(&mut File::options().write(true).open(&place)?);
    }
    let beside = beside(&place);
    let written = write_to(&beside, write).and_then(|()| Ok(fs::rename(&beside, &place)?));
    written.inspect_err(|_| {
        let _ = fs::remove_file(&beside);
    })
}

/// The same for bytes.
///
/// # Errors
/// If the file cannot be made, written, flushed or renamed.
pub(crate) fn whole_bytes(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    whole(path, |file| file.write_all(bytes))
}

fn write_to<E: From<Error>>(path: &Path, write: impl FnOnce(&mut File) -> Result<(), E>) -> Result<(), E> {
    let mut file = File::create(path)?;
    write(&mut file)?;
    Ok(file.sync_all()?)
}

/// A path that no other process writes to.
fn beside(path: &Path) -> PathBuf {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!(".{name}.{}", std::process::id()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
    }

    #[test]
    fn what_was_there_stays_until_all_of_it_is_written() {
        let folder = std::env::temp_dir().join(format!("linkwright-whole-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let path = folder.join("file");
        whole_bytes(&path, b"first").unwrap();
        let failed: Result<(), Error> = whole(&path, |file| {
            file.write_all(b"half of the sec")?;
            assert_eq!(fs::read(&path)?, b"first");
            Err(Error::other("no more room"))
        });
        assert_eq!(failed.unwrap_err().to_string(), "no more room");
        assert_eq!((fs::read(&path).unwrap(), names(&folder)), (b"first".to_vec(), vec!["file".to_owned()]));
        whole_bytes(&path, b"second").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"second");
        fs::remove_dir_all(&folder).unwrap();
    }

    #[cfg(unix)]
    #[test]
    fn links_stay_links() {
        let folder = std::env::temp_dir().join(format!("linkwright-link-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let (file, link) = (folder.join("file"), folder.join("link"));
        fs::write(&file, "first").unwrap();
        std::os::unix::fs::symlink(&file, &link).unwrap();
        whole_bytes(&link, b"second").unwrap();
        assert_eq!(fs::read(&file).unwrap(), b"second");
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        fs::remove_dir_all(&folder).unwrap();
    }
}
