//! Where side files (material libraries, textures) come from: a path written in a file in, bytes out.
//!
//! Paths use `/` and are relative to the model; [`SideFiles`](super::SideFiles) turns what files really contain
//! (backslashes, absolute paths of another machine) into such paths.

use super::LoadError;
use std::collections::BTreeMap;
use std::fs;
use std::io::{self, Read};
use std::path::{Component, Path, PathBuf};

/// Gives access to the files beside a model.
pub trait Resolver: Send + Sync {
    /// The path under which `path` can be read, or `None` if there is no such file.
    ///
    /// May answer with another spelling: a resolver that finds the file when letter case is ignored returns the real
    /// name. Equal files should give equal answers, since each is read once.
    fn find(&self, path: &str) -> Option<String>;

    /// The content of a path that [`Resolver::find`] returned. Reads at most `max_bytes` and one more: a longer
    /// result tells the caller that the file is too large.
    ///
    /// # Errors
    ///
    /// Whatever the system says.
    fn read(&self, found: &str, max_bytes: u64) -> io::Result<Vec<u8>>;
}

/// Side files in a folder, found exactly or else with letter case ignored.
///
/// Only regular files are opened, so that a path to a device or pipe cannot hang the caller.
#[derive(Clone, Debug)]
pub struct DirectoryResolver {
    base: PathBuf,
    is_confined: bool,
}

impl DirectoryResolver {
    /// Files relative to `base`; paths may lead out of it (`../textures/a.png`), as they do in models.
    #[must_use]
    pub fn new(base: impl Into<PathBuf>) -> Self {
        Self { base: base.into(), is_confined: false }
    }

    /// Refuses absolute paths and paths with `..`: for services that load models of strangers.
    #[must_use]
    pub fn confined(self) -> Self {
        Self { is_confined: true, ..self }
    }

    fn full_path(&self, path: &str) -> PathBuf {
        if self.base.as_os_str().is_empty() { PathBuf::from(path) } else { self.base.join(path) }
    }
}

impl Resolver for DirectoryResolver {
    fn find(&self, path: &str) -> Option<String> {
        let parts = || Path::new(path).components();
        if self.is_confined && !parts().all(|part| matches!(part, Component::Normal(_) | Component::CurDir)) {
            return None;
        }
        if fs::metadata(self.full_path(path)).is_ok_and(|metadata| metadata.is_file()) {
            return Some(path.to_owned());
        }
        // Walk down, each name exactly or else ignoring case.
        let mut found = PathBuf::new();
        for part in parts() {
            let next = found.join(part);
            let exists = matches!(part, Component::Normal(_)) && fs::metadata(self.base.join(&next)).is_err();
            found = if exists { found.join(name_ignoring_case(&self.base.join(&found), part)?) } else { next };
        }
        let is_file = fs::metadata(self.base.join(&found)).is_ok_and(|metadata| metadata.is_file());
        if is_file { found.to_str().map(str::to_owned) } else { None }
    }

    fn read(&self, found: &str, max_bytes: u64) -> io::Result<Vec<u8>> {
        read_file(&self.full_path(found), max_bytes)
    }
}

/// The least name in `folder` that equals `name` when case is ignored.
fn name_ignoring_case(folder: &Path, name: Component<'_>) -> Option<String> {
    let name = name.as_os_str().to_str()?.to_lowercase();
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let entries = fs::read_dir(folder).ok()?.filter_map(Result::ok);
    let names = entries.filter_map(|entry| entry.file_name().into_string().ok());
    names.filter(|entry| entry.to_lowercase() == name).min()
}

/// Reads a regular file, one byte more than `max_bytes` at most.
pub(super) fn read_file(path: &Path, max_bytes: u64) -> io::Result<Vec<u8>> {
    let file = fs::File::open(path)?;
    let metadata = file.metadata()?;
    if !metadata.is_file() {
        return Err(io::Error::new(io::ErrorKind::InvalidInput, "not a regular file"));
    }
    let size = metadata.len().min(max_bytes);
    let mut bytes = Vec::with_capacity(usize::try_from(size).unwrap_or(0) + 1);
    file.take(max_bytes.saturating_add(1)).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Side files in memory, by path; letter case counts, then is ignored.
#[derive(Clone, Debug, Default)]
pub struct MemoryResolver {
    files: BTreeMap<String, Vec<u8>>,
}

impl MemoryResolver {
    /// No files yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a file under a `/`-separated path relative to the model.
    #[must_use]
    pub fn with(mut self, path: impl Into<String>, bytes: impl Into<Vec<u8>>) -> Self {
        self.files.insert(path.into(), bytes.into());
        self
    }
}

impl Resolver for MemoryResolver {
    fn find(&self, path: &str) -> Option<String> {
        let mut names = self.files.keys();
        match self.files.contains_key(path) {
            true => Some(path.to_owned()),
            false => names.find(|name| name.to_lowercase() == path.to_lowercase()).cloned(),
        }
    }

    fn read(&self, found: &str, _max_bytes: u64) -> io::Result<Vec<u8>> {
        self.files.get(found).cloned().ok_or_else(|| io::ErrorKind::NotFound.into())
    }
}

/// No side files at all.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoSideFiles;

impl Resolver for NoSideFiles {
    fn find(&self, _path: &str) -> Option<String> {
        None
    }

    fn read(&self, _found: &str, _max_bytes: u64) -> io::Result<Vec<u8>> {
        Err(io::ErrorKind::NotFound.into())
    }
}

/// The model file itself.
pub(super) fn read_model(path: &Path, max_bytes: u64) -> Result<Vec<u8>, LoadError> {
    let file = path.display().to_string();
    let bytes = read_file(path, max_bytes).map_err(|source| LoadError::Io { file: file.clone(), source })?;
    if u64::try_from(bytes.len()).unwrap_or(u64::MAX) > max_bytes {
        return Err(LoadError::limit(&file, "file_bytes", max_bytes));
    }
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_are_searched_ignoring_case_and_confinement_holds() {
        let base = std::env::temp_dir().join(format!("trigon-resolver-{}", std::process::id()));
        fs::create_dir_all(base.join("Textures")).unwrap();
        fs::write(base.join("Textures/Wood.PNG"), b"png").unwrap();
        let resolver = DirectoryResolver::new(&base);
        assert_eq!(resolver.find("Textures/Wood.PNG").as_deref(), Some("Textures/Wood.PNG"));
        let found = resolver.find("textures/wood.png").unwrap();
        assert_eq!(resolver.read(&found, 10).unwrap(), b"png");
        assert_eq!(resolver.read(&found, 1).unwrap().len(), 2);
        assert_eq!(resolver.find("Textures"), None);
        assert_eq!(resolver.find("missing.png"), None);
        let inner = DirectoryResolver::new(base.join("Textures"));
        assert!(inner.find("../Textures/Wood.PNG").is_some());
        assert_eq!(inner.confined().find("../Textures/Wood.PNG"), None);
        fs::remove_dir_all(base).unwrap();
    }
}
