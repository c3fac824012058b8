//! The `trigon` program of this tree: built once, then run.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Where the program is.
pub(super) struct Program {
    path: PathBuf,
    root: PathBuf,
}

impl Program {
    /// Builds it as the tests of the command do: built alone, its dependencies would have other features, and all of it
    /// would be compiled once more.
    pub(super) fn build(root: &Path) -> Result<Self, String> {
        let output = Command::new(env!("CARGO"))
            .current_dir(root)
            .args(["test", "--quiet", "--workspace", "--no-run"])
            .arg("--message-format=json-render-diagnostics")
            .stderr(Stdio::inherit())
            .output()
            .map_err(|error| format!("cargo does not start: {error}"))?;
        if !output.status.success() {
            return Err(format!("trigon does not build ({})", output.status));
        }
        let path = executable(&String::from_utf8_lossy(&output.stdout)).ok_or("cargo did not name the program")?;
        Ok(Self { path, root: root.to_owned() })
    }

    /// Runs it from the workspace's root; what it prints.
    pub(super) fn run(&self, arguments: &[String]) -> Result<String, String> {
        let output = Command::new(&self.path)
            .current_dir(&self.root)
            .args(arguments)
            .stdin(Stdio::null())
            .output()
            .map_err(|error| format!("{}: {error}", self.path.display()))?;
        if output.status.success() {
            Ok(String::from_utf8_lossy(&output.stdout).replace("\r\n", "\n"))
        } else {
            Err(format!("{}: {}", output.status, String::from_utf8_lossy(&output.stderr).trim_end()))
        }
    }
}

/// The path of `trigon` in cargo's messages, one JSON object a line.
fn executable(messages: &str) -> Option<PathBuf> {
    messages.lines().rev().find_map(|line| {
        let message: serde_json::Value = serde_json::from_str(line).ok()?;
        let is_trigon = message["target"]["name"] == "trigon" && message["target"]["kind"][0] == "bin";
        let is_test = message["profile"]["test"] == true;
        message["executable"].as_str().filter(|_| is_trigon && !is_test).map(PathBuf::from)
    })
}
