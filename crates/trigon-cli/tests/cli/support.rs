//! Folders with small models, and runs of the command in them.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::atomic::{AtomicU32, Ordering};
use trigon_image::{Limits, Rgba8Image, decode};

/// A box that fits no symmetry, without normals, texture coordinates and materials.
pub(crate) const CUBE: &str = "\
v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 0 0 3\nv 2 0 3\nv 2 1 3\nv 0 1 3
f 5 6 7 8\nf 2 1 4 3\nf 6 2 3 7\nf 1 5 8 4\nf 8 7 3 4\nf 1 2 6 5
";

/// One square with a texture.
pub(crate) const TEXTURED: &str = "\
mtllib m.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1
usemtl picture\nf 1/1 2/2 3/3 4/4
";

/// A folder of one test, removed at its end.
pub(crate) struct Folder(PathBuf);

impl Folder {
    /// An empty folder.
    pub(crate) fn new() -> Self {
        static COUNT: AtomicU32 = AtomicU32::new(0);
        let name = format!("trigon-cli-{}-{}", std::process::id(), COUNT.fetch_add(1, Ordering::Relaxed));
        let path = std::env::temp_dir().join(name);
        fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    /// A folder with `cube.obj`.
    pub(crate) fn with_cube() -> Self {
        Self::new().with("cube.obj", CUBE)
    }

    pub(crate) fn with(self, name: &str, content: impl AsRef<[u8]>) -> Self {
        fs::write(self.path(name), content).unwrap();
        self
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    /// The names of all files, sorted.
    pub(crate) fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).unwrap();
        let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    /// The command in this folder, with an environment that is the same everywhere.
    pub(crate) fn command<S: AsRef<OsStr>>(&self, arguments: impl IntoIterator<Item = S>) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_trigon"));
        command.args(arguments).current_dir(&self.0).env_remove("TRIGON_SIMD").env_remove("NO_COLOR");
        command.stdin(Stdio::null());
        command
    }

    /// Runs the command with arguments separated by blanks.
    pub(crate) fn run(&self, arguments: &str) -> Finished {
        Finished::new(self.command(arguments.split_whitespace()).output().unwrap())
    }

    /// Runs the command, which must succeed without a word, and reads the picture it makes.
    pub(crate) fn picture(&self, arguments: &str) -> Rgba8Image {
        self.run(&format!("{arguments} -o picture.png")).succeeds_quietly();
        read_picture(&self.path("picture.png"))
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// What a run of the command left.
pub(crate) struct Finished {
    pub(crate) code: Option<i32>,
    pub(crate) stdout: Vec<u8>,
    pub(crate) stderr: String,
}

impl Finished {
    pub(crate) fn new(output: Output) -> Self {
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert!(!stderr.contains("panicked"), "{stderr}");
        Self { code: output.status.code(), stdout: output.stdout, stderr }
    }

    /// Exit code 0.
    pub(crate) fn succeeds(self) -> Self {
        assert_eq!(self.code, Some(0), "{}", self.stderr);
        self
    }

    /// Exit code 0 and nothing on standard error.
    pub(crate) fn succeeds_quietly(self) -> Self {
        assert_eq!(self.stderr, "");
        self.succeeds()
    }

    /// Exit code 1, and a message on standard error with all of these words; nothing on standard output.
    pub(crate) fn fails_with(self, words: &[&str]) -> Self {
        self.ends_with_code(1, words)
    }

    /// Exit code 2, and a message on standard error with all of these words; nothing on standard output.
    pub(crate) fn misuses_with(self, words: &[&str]) -> Self {
        self.ends_with_code(2, words)
    }

    /// Standard error has all of these words.
    pub(crate) fn says(self, words: &[&str]) -> Self {
        for word in words {
            assert!(self.stderr.contains(word), "\"{word}\" is not in:\n{}", self.stderr);
        }
        self
    }

    pub(crate) fn text(&self) -> &str {
        std::str::from_utf8(&self.stdout).unwrap()
    }

    fn ends_with_code(self, code: i32, words: &[&str]) -> Self {
        assert_eq!(self.code, Some(code), "{}", self.stderr);
        assert!(self.stderr.contains("error: "), "{}", self.stderr);
        assert_eq!(self.text(), "");
        self.says(words)
    }
}

pub(crate) fn read_picture(path: &Path) -> Rgba8Image {
    picture_of(&fs::read(path).unwrap())
}

pub(crate) fn picture_of(bytes: &[u8]) -> Rgba8Image {
    decode(bytes, None, &Limits::default()).unwrap().into_rgba8()
}

/// The part of the pixels that differ visibly, 0 to 1.
pub(crate) fn difference(a: &Rgba8Image, b: &Rgba8Image) -> f64 {
    assert_eq!((a.width(), a.height()), (b.width(), b.height()));
    let differs = |(a, b): &(&[u8; 4], &[u8; 4])| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > 8);
    let count = a.pixels().iter().zip(b.pixels()).filter(differs).count();
    count as f64 / a.pixels().len() as f64
}
