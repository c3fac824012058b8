//! Where real models, scenes and reference pictures lie: a folder beside the project that is no part of it.
//!
//! Included by tests of the packages in `crates/`. Where the folder is missing, a test that needs it says so and skips.

use std::path::{Path, PathBuf};

/// The shared data, where it exists.
#[expect(clippy::print_stdout, reason = "a skip must be seen")]
pub(crate) fn shared_data() -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data");
    let exists = folder.is_dir();
    if !exists {
        println!("SKIPPED: {} does not exist", folder.display());
    }
    exists.then_some(folder)
}
