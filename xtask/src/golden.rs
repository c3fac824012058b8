//! `cargo xtask bless` and `cargo xtask report`: thin wrappers around the golden tests: those of `trigon-tests`, and those
//! of `trigon-cli`, which draws presets.
//!
//! The tests compare with the stored pictures, and rewrite those that fail when `TRIGON_BLESS=1` is set. Both
//! commands only start them or say where they left their report, so that there is one comparison, not two.

use std::path::Path;
use std::process::Command;

/// The page that a failing golden test leaves behind, below the target folder.
const REPORT: &str = "golden-report/index.html";

/// Where golden tests are: the test, and what their names have in them.
const TESTS: [(&str, &str); 2] = [("golden", ""), ("cli", "goldens::")];

/// Runs the golden tests with permission to rewrite the pictures that fail; `filter` is a part of the test's name.
pub(crate) fn bless(root: &Path, filter: Option<&str>) -> Result<(), String> {
    for (test, names) in TESTS {
        let status = Command::new(env!("CARGO"))
            .current_dir(root)
            .args(["test", "--workspace", "--test", test, "--", filter.unwrap_or(names)])
            .env("TRIGON_BLESS", "1")
            .status()
            .map_err(|error| format!("cargo does not start: {error}"))?;
        if !status.success() {
            return Err(format!(
                "the golden tests in '{test}' fail even while blessing ({status}): that is not a picture's fault"
            ));
        }
    }
    println!("Blessed. Look at what changed before committing: git diff --stat -- tests/golden");
    Ok(())
}

/// Prints the path of the report of differences.
pub(crate) fn report(root: &Path) -> Result<(), String> {
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), |folder| root.join(folder));
    let page = target.join(REPORT);
    if page.is_file() {
        println!("{}", page.display());
        Ok(())
    } else {
        Err(format!("no report at {}: no golden test has failed since the folder was made", page.display()))
    }
}
