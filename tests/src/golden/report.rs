//! The page that shows what failed: expected, difference and actual picture of each case side by side.
//!
//! Each failing case has a folder of its own below the page's; the page lists the folders that are there. So tests may
//! run one by one or at once, and a case that passes again disappears.

use super::check::{png, write};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use trigon_image::Rgba8Image;
use trigon_image::compare::difference_picture;

/// Held while the folders or the page change.
static FOLDER: Mutex<()> = Mutex::new(());

/// How much differences are amplified.
const GAIN: u8 = 20;

const HEAD: &str = "<!doctype html><meta charset=utf-8><title>Golden pictures that differ</title>
<style>body{font:14px sans-serif;background:#bbb}img{image-rendering:pixelated;width:384px;margin:4px;
background:repeating-conic-gradient(#999 0 25%,#ccc 0 50%) 0 0/16px 16px}</style>
<p>expected | difference, 20 times | actual</p>\n";

/// Stores the pictures of a failed case, and returns the path of the page.
pub(super) fn add(case: &str, expected: Option<&Rgba8Image>, actual: &Rgba8Image) -> PathBuf {
    let _guard = FOLDER.lock().unwrap_or_else(PoisonError::into_inner);
    let folder = case_folder(case);
    // What another run left must not stand beside this run's pictures.
    let _ = fs::remove_dir_all(&folder);
    let difference = expected.and_then(|expected| difference_picture(expected, actual, GAIN));
    let pictures = [("expected", expected), ("difference", difference.as_ref()), ("actual", Some(actual))];
    for (name, picture) in pictures {
        if let Some(picture) = picture {
            write(&folder.join(format!("{name}.png")), &png(picture));
        }
    }
    rewrite_page()
}

/// Removes what an earlier failure of the case left.
pub(super) fn forget(case: &str) {
    let _guard = FOLDER.lock().unwrap_or_else(PoisonError::into_inner);
    if fs::remove_dir_all(case_folder(case)).is_ok() {
        rewrite_page();
    }
}

fn report_folder() -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let target = std::env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into());
    root.join(target).join("golden-report")
}

fn case_folder(case: &str) -> PathBuf {
    report_folder().join(case.replace('/', "--"))
}

/// The page lists the folders that are there; with none left it goes too.
fn rewrite_page() -> PathBuf {
    let page = report_folder().join("index.html");
    let entries = fs::read_dir(report_folder()).into_iter().flatten().flatten();
    let is_folder = |entry: &fs::DirEntry| entry.file_type().is_ok_and(|kind| kind.is_dir());
    let names = entries.filter(is_folder).map(|entry| entry.file_name().to_string_lossy().into_owned());
    let mut cases: Vec<String> = names.collect();
    cases.sort();
    if cases.is_empty() {
        let _ = fs::remove_file(&page);
        return page;
    }
    let mut html = HEAD.to_owned();
    for case in cases {
        html += &format!("<h3>{}</h3>\n", case.replace("--", "/"));
        for name in ["expected", "difference", "actual"] {
            html += &format!("<img src=\"{case}/{name}.png\" alt=\"{name}\">\n");
        }
    }
    write(&page, html.as_bytes());
    page
}
