//! Pictures that a file embeds or links to: checked as the file itself is, and named where they are missing.
//!
//! They come from strangers as the file does: linked ones are ordinary files of limited size, and SVG files among them
//! have the limits of the file around them.

use std::sync::Arc;

use usvg::{ImageHrefResolver, ImageKind};

use super::document::check_size;
use super::warnings::SharedWarnings;
use super::{Options, is_svg};
use crate::linked;

/// Reads pictures; those that are not drawn are added to `missing`.
pub(super) fn watched_pictures<'a>(options: &'a Options, missing: &'a SharedWarnings) -> ImageHrefResolver<'a> {
    ImageHrefResolver {
        resolve_data: Box::new(move |mime: &str, data: Arc<Vec<u8>>, own: &usvg::Options<'_>| {
            let picture = read(mime, data, options, own);
            picture.map_err(|error| missing.add(format!("an embedded picture is not drawn: {error}"))).ok()
        }),
        resolve_string: Box::new(move |link: &str, own: &usvg::Options<'_>| {
            let bytes = match &options.folder {
                Some(folder) => linked::read(&folder.join(link), options.limits.max_bytes),
                None => Err("linked files are not read".to_owned()),
            };
            let picture = bytes.and_then(|bytes| read(BY_CONTENT, Arc::new(bytes), options, own));
            // A broken `data:` link comes here too, and may be long.
            let link: String = link.chars().take(100).collect();
            picture.map_err(|error| missing.add(format!("the picture '{link}' is not drawn: {error}"))).ok()
        }),
    }
}

/// The type under which the content says what it is.
const BY_CONTENT: &str = "text/plain";

fn read(mime: &str, data: Arc<Vec<u8>>, options: &Options, own: &usvg::Options<'_>) -> Result<ImageKind, String> {
    if is_svg(&data) {
        check_size(&data, &options.limits).map_err(|error| error.to_string())?;
    }
    let picture = ImageHrefResolver::default_data_resolver()(mime, data, own);
    picture.ok_or_else(|| "it is no PNG, JPEG, GIF, WebP or SVG file".to_owned())
}
