//! The generated files against the folder `assets/`: write them, or check that they are there unchanged.

use std::path::Path;

use super::models::files;

/// Files in the folder that are written by hand.
const BY_HAND: [&str; 1] = ["README.md"];

/// Writes every generated file and prints its size.
pub(crate) fn write(root: &Path) -> Result<(), String> {
    let folder = root.join("assets");
    let failed = |error: std::io::Error| format!("cannot write below {}: {error}", folder.display());
    std::fs::create_dir_all(folder.join("textures")).map_err(failed)?;
    let mut total = 0;
    for (name, content) in files() {
        std::fs::write(folder.join(&name), &content).map_err(failed)?;
        println!("{:>8}  {name}", content.len());
        total += content.len();
    }
    println!("{total:>8}  in all");
    Ok(())
}

/// Fails if a generated file is missing or differs, or if the folder holds anything else.
pub(crate) fn check(root: &Path) -> Result<(), String> {
    let folder = root.join("assets");
    let files = files();
    let mut problems = Vec::new();
    for (name, content) in &files {
        match std::fs::read(folder.join(name)) {
            Ok(stored) if stored == *content => {}
            Ok(_) => problems.push(format!("assets/{name} differs from what the generator makes")),
            Err(error) => problems.push(format!("assets/{name}: {error}")),
        }
    }
    for name in stored_names(&folder).map_err(|error| format!("cannot list {}: {error}", folder.display()))? {
        if !BY_HAND.contains(&name.as_str()) && !files.iter().any(|(known, _)| *known == name) {
            problems.push(format!("assets/{name} is not made by the generator"));
        }
    }
    if problems.is_empty() {
        println!("assets: {} files are what the generator makes", files.len());
        Ok(())
    } else {
        Err(format!("{}\nrun `cargo xtask assets` and commit the result", problems.join("\n")))
    }
}

/// Paths of all files below the folder, with forward slashes, one level of folders deep.
fn stored_names(folder: &Path) -> std::io::Result<Vec<String>> {
    let mut names = Vec::new();
    for entry in std::fs::read_dir(folder)? {
        let entry = entry?;
        let name = entry.file_name().to_string_lossy().into_owned();
        if entry.file_type()?.is_dir() {
            for inner in std::fs::read_dir(entry.path())? {
                names.push(format!("{name}/{}", inner?.file_name().to_string_lossy()));
            }
        } else {
            names.push(name);
        }
    }
    names.sort();
    Ok(names)
}
