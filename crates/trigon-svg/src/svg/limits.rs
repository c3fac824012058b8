//! What a file may cost at most; every value is settable.

/// What a file may cost at most. Beyond, a file is refused or, where it says so, drawn with less.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Limits {
    /// Bytes of the file, after decompression; more is an error.
    pub max_bytes: usize,
    /// Levels of elements inside each other; more is an error.
    pub max_element_depth: usize,
    /// Elements, after every `use`, marker and pattern is put in; more is an error.
    pub max_elements: usize,
    /// Elements times selectors of style sheets; more is an error.
    pub max_style_steps: u64,
    /// Groups inside each other that are drawn; deeper ones are left out, with a warning.
    pub max_depth: usize,
    /// Pixels of a filter's region. A larger region is cut to what lies near the picture, with a warning.
    pub max_filter_pixels: u64,
    /// Pixels of a pattern's tile. A larger one is drawn with fewer pixels, with a warning.
    pub max_tile_pixels: u64,
    /// Steps of work, in pixels times weights, of one `feConvolveMatrix`; above, its input is its result, with a warning.
    pub max_convolution_steps: u64,
    /// Pixels of all embedded and linked images together; further ones are left out, with a warning.
    pub max_image_pixels: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            max_bytes: 1 << 28,
            max_element_depth: 1024,
            max_elements: 1_000_000,
            max_style_steps: 1 << 26,
            max_depth: 1024,
            max_filter_pixels: 1 << 26,
            max_tile_pixels: 1 << 25,
            max_convolution_steps: 1 << 34,
            max_image_pixels: 1 << 28,
        }
    }
}
