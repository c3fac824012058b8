//! Files that appear whole or not at all: written under another name in the same folder, then renamed.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};

/// Writes a file so that `path` holds either what it held before or all of `bytes`, even if the process dies.
///
/// # Errors
/// If the file cannot be made, written or renamed; `path` is then as before and nothing is left beside it.
pub fn write_atomically(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = AtomicFile::create(path)?;
    file.write_all(bytes)?;
    file.commit()
}

/// A file being written that replaces `path` only on [`commit`](Self::commit); dropped before that, it leaves no trace.
#[derive(Debug)]
pub struct AtomicFile {
    path: PathBuf,
    temporary_path: PathBuf,
    /// `None` once committed.
    file: Option<File>,
}

impl AtomicFile {
    /// Starts a file that will become `path`, in the folder of `path`, which must exist.
    ///
    /// # Errors
    /// If `path` has no file name, or no file can be made in its folder.
    pub fn create(path: &Path) -> io::Result<Self> {
        static COUNTER: AtomicU32 = AtomicU32::new(0);
        let Some(name) = path.file_name() else {
            return Err(io::Error::new(io::ErrorKind::InvalidInput, format!("{} is no file name", path.display())));
        };
        if path.is_dir() {
            return Err(io::Error::new(io::ErrorKind::IsADirectory, format!("{} is a folder", path.display())));
        }
        loop {
            let mut temporary_name = std::ffi::OsString::from(".");
            temporary_name.push(name);
            let count = COUNTER.fetch_add(1, Ordering::Relaxed);
            temporary_name.push(format!(".{}-{count}.part", std::process::id()));
            let temporary_path = path.with_file_name(temporary_name);
            match OpenOptions::new().write(true).create_new(true).open(&temporary_path) {
                Ok(file) => return Ok(Self { path: path.to_owned(), temporary_path, file: Some(file) }),
                // Left by a process of the same id that was killed: take the next name.
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => return Err(error),
            }
        }
    }

    /// Makes the file appear under its name.
    ///
    /// # Errors
    /// If the rest cannot be written or the file cannot be renamed; nothing is left then.
    pub fn commit(mut self) -> io::Result<()> {
        // Data must be on the disk before the name points to it; closed, because Windows renames no open file.
        if let Some(file) = &self.file {
            file.sync_data()?;
        }
        drop(self.file.take());
        fs::rename(&self.temporary_path, &self.path).inspect_err(|_| {
            let _ = fs::remove_file(&self.temporary_path);
        })
    }
}

impl Write for AtomicFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.file {
            Some(file) => file.write(bytes),
            None => Err(io::Error::other("the file is committed")),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.as_mut().map_or(Ok(()), File::flush)
    }
}

impl Drop for AtomicFile {
    fn drop(&mut self) {
        if self.file.take().is_some() {
            // Nothing more can be done if this fails too.
            let _ = fs::remove_file(&self.temporary_path);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A fresh folder of one test, removed at its end.
    struct Folder(PathBuf);

    impl Folder {
        fn new(name: &str) -> Self {
            let path = std::env::temp_dir().join(format!("trigon-image-{name}-{}", std::process::id()));
            fs::create_dir_all(&path).unwrap();
            Self(path)
        }

        fn names(&self) -> Vec<String> {
            fs::read_dir(&self.0).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
        }
    }

    impl Drop for Folder {
        fn drop(&mut self) {
            let _ = fs::remove_dir_all(&self.0);
        }
    }

    #[test]
    fn a_file_is_made_and_replaced() {
        let folder = Folder::new("replaced");
        let path = folder.0.join("a.png");
        for bytes in [&b"first, longer"[..], b"second"] {
            write_atomically(&path, bytes).unwrap();
            assert_eq!(fs::read(&path).unwrap(), bytes);
        }
        assert_eq!(folder.names(), ["a.png"]);
    }

    #[test]
    fn a_dropped_file_leaves_no_trace() {
        let folder = Folder::new("dropped");
        let path = folder.0.join("a.png");
        write_atomically(&path, b"before").unwrap();
        let mut file = AtomicFile::create(&path).unwrap();
        file.write_all(b"half").unwrap();
        assert_eq!(folder.names().len(), 2);
        drop(file);
        assert_eq!(folder.names(), ["a.png"]);
        assert_eq!(fs::read(&path).unwrap(), b"before");
    }

    #[test]
    fn failures_leave_nothing() {
        let folder = Folder::new("failures");
        assert!(write_atomically(&folder.0.join("missing/a.png"), b"x").is_err());
        assert_eq!(write_atomically(&folder.0, b"x").unwrap_err().kind(), io::ErrorKind::IsADirectory);
        assert_eq!(write_atomically(Path::new("/"), b"x").unwrap_err().kind(), io::ErrorKind::InvalidInput);
        // The name becomes a folder while the file is written: the rename fails.
        let path = folder.0.join("late");
        let file = AtomicFile::create(&path).unwrap();
        fs::create_dir(&path).unwrap();
        assert!(file.commit().is_err());
        assert_eq!(folder.names(), ["late"]);
    }
}
