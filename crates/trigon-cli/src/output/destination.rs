//! Files and standard output: finished bytes in; a file that is there whole, or an error and no file.
//!
//! What can be known beforehand is checked before anything is drawn. Regular files are written under another name and
//! renamed; devices and pipes are written as they are, because they cannot be replaced.

use crate::deadline;
use crate::failure::Failure;
use crate::terminal;
use std::fs::{self, OpenOptions};
use std::io::{self, ErrorKind, IsTerminal, Write};
use std::path::{Path, PathBuf};
use trigon_image::write_atomically;

/// Where bytes go.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Destination {
    /// Standard output.
    Stdout,
    /// A file, device or named pipe.
    File(PathBuf),
}

impl Destination {
    /// `-` is standard output.
    pub(crate) fn new(path: &Path) -> Self {
        if path.as_os_str() == "-" { Self::Stdout } else { Self::File(path.to_owned()) }
    }

    /// The name for messages and reports.
    pub(crate) fn name(&self) -> String {
        match self {
            Self::Stdout => "-".to_owned(),
            Self::File(path) => path.display().to_string(),
        }
    }

    /// Whether it is there already and no regular file: a device or a pipe.
    pub(crate) fn is_device(&self) -> bool {
        match self {
            Self::Stdout => true,
            Self::File(path) => fs::metadata(path).is_ok_and(|metadata| !metadata.is_file() && !metadata.is_dir()),
        }
    }

    /// Finds what would make writing fail, without touching anything.
    pub(crate) fn check(&self, inputs: &[PathBuf]) -> Result<(), Failure> {
        let Self::File(path) = self else { return check_stdout() };
        let shown = path.display();
        if path.is_dir() {
            return Err(Failure::work(format!("cannot write {shown}: it is a folder; name a file in it")));
        }
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
        if let Some(folder) = folder.filter(|folder| !folder.is_dir()) {
            let problem = if folder.exists() { "is no folder" } else { "does not exist; create the folder first" };
            return Err(Failure::work(format!("cannot write {shown}: {} {problem}", folder.display())));
        }
        self.check_not_among(inputs)
    }

    /// Refuses to overwrite what is read.
    pub(crate) fn check_not_among(&self, inputs: &[PathBuf]) -> Result<(), Failure> {
        let Self::File(path) = self else { return Ok(()) };
        let Ok(real) = fs::canonicalize(path) else { return Ok(()) };
        let is_input = |input: &PathBuf| fs::canonicalize(input).is_ok_and(|input| input == real);
        match inputs.iter().find(|input| is_input(input)) {
            Some(input) if !self.is_device() => Err(Failure::usage(format!(
                "the output {} would overwrite the input {}; choose another name",
                path.display(),
                input.display()
            ))),
            _ => Ok(()),
        }
    }

    /// Writes all of `bytes`, or leaves the file as it was.
    pub(crate) fn write(&self, bytes: &[u8]) -> Result<(), Failure> {
        let _written_whole = deadline::writing();
        let Self::File(path) = self else { return terminal::write_stdout(bytes) };
        let written = if self.is_device() {
            OpenOptions::new().write(true).open(path).and_then(|mut device| device.write_all(bytes))
        } else {
            write_atomically(&followed(path), bytes)
        };
        written.map_err(|error| match error.kind() {
            ErrorKind::BrokenPipe => Failure::ClosedPipe,
            _ => Failure::work(format!("cannot write {}: {error}{}", path.display(), advice(&error))),
        })
    }
}

fn check_stdout() -> Result<(), Failure> {
    if io::stdout().is_terminal() {
        return Err(Failure::usage("a picture would garble the terminal; redirect standard output, or name a file"));
    }
    Ok(())
}

/// The file that a symbolic link leads to: renaming onto the link would replace the link.
fn followed(path: &Path) -> PathBuf {
    let is_link = fs::symlink_metadata(path).is_ok_and(|metadata| metadata.is_symlink());
    if is_link { fs::canonicalize(path).unwrap_or_else(|_| path.to_owned()) } else { path.to_owned() }
}

/// What the person can do about it.
fn advice(error: &io::Error) -> &'static str {
    match error.kind() {
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded => "; free some space, or write somewhere else",
        ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem => "; write where you have permission to",
        ErrorKind::FileTooLarge => "; the file system or a limit of the shell does not allow files of this size",
        ErrorKind::InvalidFilename => "; choose a shorter name",
        _ => "",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn message(failure: Result<(), Failure>) -> String {
        match failure.unwrap_err() {
            Failure::Usage(message) | Failure::Table(message) | Failure::Work(message) => message,
            Failure::ClosedPipe => String::new(),
        }
    }

    #[test]
    fn problems_are_found_before_writing() {
        let folder = std::env::temp_dir();
        assert!(message(Destination::new(&folder).check(&[])).contains("is a folder"));
        let missing = folder.join("trigon-no-such-folder/a.png");
        assert!(message(Destination::new(&missing).check(&[])).contains("create the folder first"));
        assert_eq!(Destination::new(Path::new("a-new-file.png")).check(&[]), Ok(()));
    }

    #[test]
    fn inputs_are_not_overwritten_under_any_name() {
        let folder = std::env::temp_dir().join(format!("trigon-destination-{}", std::process::id()));
        fs::create_dir_all(folder.join("sub")).unwrap();
        let input = folder.join("a.obj");
        fs::write(&input, b"v 0 0 0").unwrap();
        let other_spelling = Destination::new(&folder.join("sub/../a.obj"));
        assert!(message(other_spelling.check(&[input])).contains("would overwrite the input"));
        fs::remove_dir_all(folder).unwrap();
    }

    #[cfg(unix)]
    #[test]
    fn links_stay_links() {
        let folder = std::env::temp_dir().join(format!("trigon-links-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let (file, link) = (folder.join("real.png"), folder.join("link.png"));
        fs::write(&file, b"before").unwrap();
        std::os::unix::fs::symlink(&file, &link).unwrap();
        Destination::new(&link).write(b"after").unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::read(&file).unwrap(), b"after");
        fs::remove_dir_all(folder).unwrap();
    }
}
