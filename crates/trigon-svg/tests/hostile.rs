//! Files made to hurt: each ends, in bounded time and memory, in a picture or a clear error; never in a panic.

use std::fmt::Write;
use std::io::Write as _;
use std::time::{Duration, Instant};

use trigon_image::Color;
use trigon_svg::canvas::{Picture, Renderer};
use trigon_svg::svg::{Document, FontOptions, Options, Size, SvgError, View, Warning};

/// Far above what any case takes, far below what an unbounded one would.
const PATIENCE: Duration = Duration::from_secs(60);

fn options() -> Options {
    let fonts = FontOptions { use_system_fonts: false, ..FontOptions::default() };
    Options { fonts, ..Options::default() }
}

fn draw(svg: &str) -> Result<(Picture, Vec<Warning>), SvgError> {
    let started = Instant::now();
    let view = View { size: Size::Width(64), ..View::default() };
    let drawn = Document::parse(svg.as_bytes(), &options())
        .and_then(|document| document.draw(&view, &Renderer::new(), Color::TRANSPARENT));
    assert!(started.elapsed() < PATIENCE, "took {:?}", started.elapsed());
    drawn
}

fn page(content: &str) -> String {
    format!(
        "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' viewBox='0 0 64 64'>{content}</svg>"
    )
}

/// A picture or a limit: what a bounded bomb may give.
fn ends(svg: &str) {
    match draw(svg) {
        Ok(_) | Err(SvgError::LimitExceeded(_) | SvgError::Malformed(_) | SvgError::Draw(_)) => {}
        Err(error) => panic!("{error}"),
    }
}

#[test]
fn elements_nested_too_deep_are_an_error() {
    for depth in [2_000, 200_000] {
        let svg = page(&format!("{}<rect width='9' height='9'/>{}", "<g>".repeat(depth), "</g>".repeat(depth)));
        let error = draw(&svg).map(|_| ()).unwrap_err();
        assert!(matches!(error, SvgError::LimitExceeded(_) | SvgError::Malformed(_)), "{error}");
    }
}

#[test]
fn elements_nested_just_not_too_deep_are_drawn_or_named() {
    let opening = "<g opacity='0.999'>".repeat(900);
    ends(&page(&format!("{opening}<rect width='9' height='9'/>{}", "</g>".repeat(900))));
    let (picture, _) =
        draw(&page(&format!("{}<rect width='64' height='64'/>{}", "<g>".repeat(900), "</g>".repeat(900)))).unwrap();
    assert_eq!(picture.pixels()[0], [0, 0, 0, 255]);
}

#[test]
fn copies_of_copies_end() {
    let mut content = "<defs><g id='a0'><rect width='9' height='9'/></g>".to_owned();
    for level in 1..40 {
        let uses = format!("<use xlink:href='#a{}'/>", level - 1).repeat(10);
        write!(content, "<g id='a{level}'>{uses}</g>").unwrap();
    }
    content += "</defs><use xlink:href='#a39'/>";
    assert!(matches!(draw(&page(&content)), Err(SvgError::LimitExceeded(_))));
}

#[test]
fn patterns_in_patterns_end() {
    let mut content =
        "<pattern id='p0' width='2' height='2' patternUnits='userSpaceOnUse'><rect width='1' height='1'/></pattern>"
            .to_owned();
    for level in 1..18 {
        let shape = format!("<rect width='2' height='2' fill='url(#p{})'/>", level - 1).repeat(2);
        write!(content, "<pattern id='p{level}' width='4' height='4' patternUnits='userSpaceOnUse'>{shape}</pattern>")
            .unwrap();
    }
    ends(&page(&format!("{content}<rect width='64' height='64' fill='url(#p17)'/>")));
}

#[test]
fn masks_on_masks_and_clips_on_clips_end() {
    let mut content = String::new();
    for level in 0..200 {
        write!(
            content,
            "<mask id='m{level}' mask='url(#m{0})'><rect width='64' height='64' fill='white'/></mask>
             <clipPath id='c{level}' clip-path='url(#c{0})'><rect width='64' height='64'/></clipPath>",
            level + 1
        )
        .unwrap();
    }
    ends(&page(&format!("{content}<rect width='64' height='64' mask='url(#m0)' clip-path='url(#c0)'/>")));
}

#[test]
fn references_in_circles_end() {
    for content in [
        "<use id='a' xlink:href='#a'/>",
        "<g id='a'><use xlink:href='#b'/></g><g id='b'><use xlink:href='#a'/></g>",
        "<mask id='a' mask='url(#a)'><rect width='9' height='9' mask='url(#a)'/></mask><rect width='9' height='9' mask='url(#a)'/>",
        "<pattern id='a' width='9' height='9'><rect width='9' height='9' fill='url(#a)'/></pattern><rect width='9' height='9' fill='url(#a)'/>",
        "<filter id='a'><feImage xlink:href='#b'/></filter><rect id='b' width='9' height='9' filter='url(#a)'/>",
        "<linearGradient id='a' xlink:href='#a'/><rect width='9' height='9' fill='url(#a)'/>",
    ] {
        ends(&page(content));
    }
}

#[test]
fn giant_pictures_are_refused() {
    for size in ["1000000000", "1e30", "100000"] {
        let svg = format!(
            "<svg xmlns='http://www.w3.org/2000/svg' width='{size}' height='{size}'><rect width='9' height='9'/></svg>"
        );
        let document = Document::parse(svg.as_bytes(), &options());
        let drawn = document.and_then(|document| document.draw(&View::default(), &Renderer::new(), Color::WHITE));
        let error = drawn.map(|_| ()).unwrap_err();
        assert!(matches!(error, SvgError::Draw(_) | SvgError::Malformed(_) | SvgError::Empty), "{error}");
    }
}

#[test]
fn filter_regions_of_billions_of_pixels_are_cut() {
    let region = "x='-100000' y='-100000' width='200000' height='200000' filterUnits='userSpaceOnUse'";
    for primitive in [
        "<feGaussianBlur stdDeviation='1000000'/>",
        "<feFlood flood-color='red'/><feTile/>",
        "<feOffset dx='1e9' dy='-1e9'/>",
        "<feMorphology operator='dilate' radius='100000'/>",
        "<feTurbulence baseFrequency='1e9' numOctaves='1000000000'/>",
        "<feDisplacementMap in2='SourceGraphic' scale='1e30'/>",
        "<feImage xlink:href='#r'/>",
    ] {
        let svg = page(&format!(
            "<filter id='f' {region}>{primitive}</filter><rect id='r' width='9' height='9' filter='url(#f)'/>"
        ));
        draw(&svg).unwrap();
    }
}

#[test]
fn a_convolution_over_the_limit_is_left_out_and_named() {
    let kernel = "1 ".repeat(300 * 300);
    let filter = format!(
        "<filter id='f' x='-1000%' y='-1000%' width='2100%' height='2100%'><feConvolveMatrix order='300' kernelMatrix='{kernel}'/></filter>"
    );
    let mut options = options();
    options.limits.max_convolution_steps = 1 << 20;
    let svg = page(&format!("{filter}<rect width='64' height='64' filter='url(#f)'/>"));
    let document = Document::parse(svg.as_bytes(), &options).unwrap();
    let (_, warnings) = document.draw(&View::default(), &Renderer::new(), Color::TRANSPARENT).unwrap();
    assert!(warnings.iter().any(|warning| warning.message.contains("feConvolveMatrix")), "{warnings:?}");
}

#[test]
fn dashes_and_coordinates_beyond_reason_end() {
    for content in [
        "<path d='M0 0H1e30' stroke='red' stroke-dasharray='1e-6'/>",
        "<path d='M0 0L64 64' stroke='red' stroke-width='1e30'/>",
        "<path d='M-1e38 0L1e38 1e38V-1e38Z'/>",
        "<path d='M0 0C1e30 -1e30 -1e30 1e30 64 64' stroke='red' fill='none' stroke-dasharray='0.001'/>",
        "<rect width='64' height='64' transform='scale(1e20)'/>",
        "<rect width='64' height='64' transform='matrix(1e-30 0 0 1e30 0 0)' stroke='red'/>",
        "<pattern id='p' width='1e-9' height='1e9' patternUnits='userSpaceOnUse'><rect width='1' height='1'/></pattern><rect width='64' height='64' fill='url(#p)'/>",
        "<radialGradient id='g' r='1e-30' fx='5' fr='1e30' spreadMethod='repeat'><stop/><stop offset='1'/></radialGradient><rect width='64' height='64' fill='url(#g)'/>",
    ] {
        ends(&page(content));
    }
}

#[test]
fn compressed_bombs_are_refused() {
    let mut packer = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::best());
    packer.write_all(b"<svg xmlns='http://www.w3.org/2000/svg'>").unwrap();
    (0..64).for_each(|_| packer.write_all(&vec![b' '; 1 << 20]).unwrap());
    let mut options = options();
    options.limits.max_bytes = 1 << 20;
    let error = Document::parse(&packer.finish().unwrap(), &options).map(|_| ()).unwrap_err();
    assert!(matches!(error, SvgError::LimitExceeded(_)), "{error}");
}

#[test]
fn entities_that_multiply_end() {
    let mut svg = "<!DOCTYPE svg [<!ENTITY a0 'aaaaaaaaaaaaaaaa'>".to_owned();
    for level in 1..30 {
        write!(svg, "<!ENTITY a{level} '{}'>", format!("&a{};", level - 1).repeat(10)).unwrap();
    }
    svg += "]><svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'><text>&a29;</text></svg>";
    ends(&svg);
}

#[test]
fn every_beginning_of_a_file_ends() {
    let svg = page(
        "<defs><linearGradient id='g'><stop offset='0.5' stop-color='red'/></linearGradient>
         <filter id='f'><feGaussianBlur stdDeviation='2'/><feDropShadow dx='1'/></filter><clipPath id='c'><circle r='30'/></clipPath></defs>
         <style>.a { fill: url(#g) } </style>
         <g filter='url(#f)' clip-path='url(#c)' opacity='.5'><path class='a' d='M1 1 20.5 30q1 2 3 4a5 6 7 0 1 8 9z' stroke='#123' stroke-dasharray='3 1'/></g>
         <text x='5' y='9'>text</text><image width='9' height='9' xlink:href='data:image/png;base64,iVBORw0KGgo='/>",
    );
    for end in (0..svg.len()).filter(|end| svg.is_char_boundary(*end)) {
        let view = View::default();
        let _ = Document::parse(&svg.as_bytes()[..end], &options())
            .and_then(|document| document.draw(&view, &Renderer::new(), Color::TRANSPARENT));
    }
    draw(&svg).unwrap();
}

#[test]
fn numbers_that_the_reader_cannot_bear_are_an_error() {
    for number in ["2147483648", "1e30"] {
        ends(&page(&format!(
            "<filter id='f' x='0' width='0.5'><feFlood/></filter><rect x='{number}' width='160' height='160' filter='url(#f)' transform='scale(0.1)'/>"
        )));
    }
}

#[test]
fn broken_images_are_named() {
    let (_, warnings) = draw(&page(
        "<image width='9' height='9' xlink:href='data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAA//8AAP//CAYAAAAfFcSJ'/>",
    ))
    .unwrap();
    assert!(warnings.iter().any(|warning| warning.message.contains("image")), "{warnings:?}");
}

#[test]
fn curves_far_beyond_the_picture_end() {
    // The picture lies well inside of each circle; the second one is a clip path.
    let clip = "<clipPath id='c'><circle cx='32' r='1e30'/></clipPath>";
    let clipped = format!("{clip}<rect width='64' height='64' clip-path='url(#c)'/>");
    for svg in ["<circle cx='32' r='1e30'/>", &clipped] {
        let (picture, _) = draw(&page(svg)).unwrap();
        assert!(picture.pixels().iter().all(|pixel| *pixel == [0, 0, 0, 255]), "{svg}");
    }
    for stroke in ["", " stroke-dasharray='5'", " stroke-width='1e29' stroke-dasharray='1e20'"] {
        ends(&page(&format!("<circle cx='32' r='1e30' fill='none' stroke='red'{stroke}/>")));
    }
}

#[test]
fn dashes_of_many_contours_end() {
    let contours = "M0 0H9e9".repeat(5_000);
    ends(&page(&format!("<path d='{contours}' stroke='red' stroke-linecap='round' stroke-dasharray='1e4'/>")));
}

#[test]
fn style_sheets_that_would_hardly_end_are_an_error() {
    let rules = |count: usize| (0..count).map(|i| format!("g > rect.a{i}, .b{i} {{ fill: red }}")).collect::<String>();
    let file = |count: usize| page(&format!("<style>{}</style>{}", rules(count), "<rect class='c'/>".repeat(4000)));
    assert!(matches!(draw(&file(20_000)), Err(SvgError::LimitExceeded(_))));
    assert!(draw(&file(20)).is_ok());
    // Inside of a file it has the same limits.
    let escaped = file(20_000).replace('%', "%25").replace('#', "%23").replace('"', "%22").replace('<', "%3C");
    let embedded = format!("<image width='9' height='9' href=\"data:image/svg+xml,{escaped}\"/>");
    let started = std::time::Instant::now();
    assert!(draw(&page(&embedded)).is_ok());
    assert!(started.elapsed() < std::time::Duration::from_secs(10), "{:?}", started.elapsed());
    // What is in declarations is no selector.
    let colors = "rect { fill: rgb(1,2,3); stroke: rgba(1,2,3,0.5) }".repeat(400);
    let page = page(&format!("<style>{colors}</style>{}", "<rect/>".repeat(100_000)));
    assert!(draw(&page).is_ok());
}
