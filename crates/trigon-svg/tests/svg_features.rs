//! SVG features by the color of single pixels: what each must do, where nothing is left to taste.

use trigon::lanes::SimdLevel;
use trigon::shade::texture::{LevelFilter, PixelFilter, Wrap};
use trigon_image::Color;
use trigon_svg::canvas::{ImageFilter, Picture, Renderer};
use trigon_svg::svg::{Area, Document, FontOptions, Options, Size, SvgError, View};

const GREEN: [u8; 4] = [0, 128, 0, 255];
const RED: [u8; 4] = [255, 0, 0, 255];
const CLEAR: [u8; 4] = [0; 4];

fn parse(content: &str) -> Document {
    let svg = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' viewBox='0 0 40 40'>{content}</svg>"
    );
    let fonts = FontOptions { use_system_fonts: false, ..FontOptions::default() };
    Document::parse(svg.as_bytes(), &Options { fonts, ..Options::default() }).unwrap()
}

fn draw(content: &str) -> Picture {
    let (picture, warnings) = parse(content).draw(&View::default(), &Renderer::new(), Color::TRANSPARENT).unwrap();
    assert!(warnings.is_empty(), "{warnings:?}");
    assert_eq!((picture.width(), picture.height()), (40, 40));
    picture
}

/// The picture has these colors at these places.
fn check(content: &str, expected: &[(u32, u32, [u8; 4])]) {
    let picture = draw(content);
    for &(x, y, color) in expected {
        assert_eq!(picture.pixels()[(y * 40 + x) as usize], color, "({x}, {y}) of {content}");
    }
}

#[test]
fn fills_and_paint_order() {
    check("<rect width='20' height='40' fill='green'/>", &[(5, 5, GREEN), (19, 39, GREEN), (20, 5, CLEAR)]);
    check(
        "<path d='M0 0H40V40H0zM10 10H30V30H10z' fill='green' fill-rule='evenodd'/>",
        &[(5, 5, GREEN), (20, 20, CLEAR)],
    );
    let both = "<rect x='10' y='10' width='20' height='20' fill='green' stroke='red' stroke-width='10'";
    check(&format!("{both}/>"), &[(12, 20, RED), (6, 20, RED), (20, 20, GREEN)]);
    check(&format!("{both} paint-order='stroke'/>"), &[(12, 20, GREEN), (6, 20, RED)]);
}

#[test]
fn clips_nest_and_intersect() {
    let clips = "<clipPath id='a'><rect width='30' height='30'/></clipPath>
        <clipPath id='b' clip-path='url(#a)'><rect x='10' y='10' width='30' height='30'/></clipPath>
        <clipPath id='c'><rect width='40' height='40' clip-path='url(#b)'/></clipPath>";
    for id in ["b", "c"] {
        let shape = format!("{clips}<rect width='40' height='40' fill='green' clip-path='url(#{id})'/>");
        check(&shape, &[(20, 20, GREEN), (5, 5, CLEAR), (35, 35, CLEAR)]);
    }
}

#[test]
fn masks_weigh_by_luminance_or_alpha() {
    let mask = |kind: &str| {
        format!(
            "<mask id='m' maskUnits='userSpaceOnUse' x='0' y='0' width='30' height='40' {kind}><rect width='20' height='40' fill='white'/>
             <rect x='20' width='20' height='40' fill='black'/></mask><rect width='40' height='40' fill='green' mask='url(#m)'/>"
        )
    };
    check(&mask(""), &[(5, 5, GREEN), (25, 5, CLEAR), (35, 5, CLEAR)]);
    check(&mask("mask-type='alpha'"), &[(5, 5, GREEN), (25, 5, GREEN), (35, 5, CLEAR)]);
}

#[test]
fn groups_fade_as_one() {
    let group =
        "<g opacity='0.5'><rect width='20' height='40' fill='red'/><rect width='40' height='40' fill='green'/></g>";
    check(group, &[(5, 5, [0, 64, 0, 128]), (30, 5, [0, 64, 0, 128])]);
}

#[test]
fn patterns_repeat_in_both_directions() {
    let pattern = "<pattern id='p' width='8' height='8' x='2' patternUnits='userSpaceOnUse'><rect width='4' height='8' fill='green'/></pattern>
        <rect width='40' height='40' fill='url(#p)'/>";
    check(pattern, &[(2, 0, GREEN), (5, 39, GREEN), (6, 5, CLEAR), (9, 5, CLEAR), (10, 5, GREEN), (0, 0, CLEAR)]);
}

#[test]
fn filters_work_along_the_axes_of_their_element() {
    let filter = "<filter id='f' x='0' y='0' width='1' height='1' color-interpolation-filters='sRGB'>
        <feFlood flood-color='green' x='10' y='10' width='10' height='20'/></filter>";
    let upright = format!("{filter}<rect width='40' height='40' filter='url(#f)'/>");
    check(&upright, &[(10, 10, GREEN), (19, 29, GREEN), (20, 15, CLEAR), (15, 30, CLEAR)]);
    let turned = format!("{filter}<rect width='40' height='40' filter='url(#f)' transform='rotate(90 20 20)'/>");
    check(&turned, &[(11, 11, GREEN), (28, 18, GREEN), (15, 21, CLEAR), (31, 15, CLEAR)]);
    let mirrored = format!("{filter}<rect width='40' height='40' filter='url(#f)' transform='matrix(-1 0 0 1 40 0)'/>");
    check(&mirrored, &[(21, 11, GREEN), (28, 28, GREEN), (18, 15, CLEAR), (31, 15, CLEAR)]);
}

#[test]
fn filters_read_pictures_and_earlier_results() {
    check(
        "<filter id='f' x='0' y='0' width='1' height='1'><feImage xlink:href='#r'/></filter><defs><rect id='r' width='20' height='40' fill='green'/></defs>
         <rect width='40' height='40' fill='red' filter='url(#f)'/>",
        &[(5, 5, GREEN), (30, 5, CLEAR)],
    );
    check(
        "<filter id='f' x='0' y='0' width='1' height='1' color-interpolation-filters='sRGB'><feOffset dx='10' result='a'/><feFlood flood-color='red'/>
         <feComposite in2='a' operator='in'/><feMerge><feMergeNode/><feMergeNode in='SourceGraphic'/></feMerge></filter>
         <g filter='url(#f)'><rect width='20' height='20' fill='green'/><rect width='40' height='40' fill='none'/></g>",
        &[(5, 5, GREEN), (19, 5, GREEN), (5, 25, CLEAR)],
    );
}

#[test]
fn a_filter_far_larger_than_the_picture_is_the_same_in_it() {
    let blur = |size: u32| {
        draw(&format!(
            "<filter id='f'><feGaussianBlur stdDeviation='3'/></filter><rect x='20' y='-{size}' width='{size}' height='{}' filter='url(#f)'/>",
            3 * size
        ))
    };
    assert_eq!(blur(500), blur(20_000));
}

#[test]
fn embedded_files_are_drawn_in_their_place() {
    let inner = "&lt;svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1 1'&gt;&lt;rect width='1' height='1' fill='green'/&gt;&lt;/svg&gt;";
    check(
        &format!("<image x='10' y='10' width='20' height='20' xlink:href=\"data:image/svg+xml;utf8,{inner}\"/>"),
        &[(10, 10, GREEN), (29, 29, GREEN), (5, 5, CLEAR), (31, 20, CLEAR)],
    );
}

#[test]
fn one_element_can_be_drawn_alone() {
    let document = parse(
        "<g transform='translate(10 10)'><rect id='r' width='10' height='5' fill='green'/></g><rect width='40' height='40' fill='red'/>",
    );
    let view = View { area: Area::Drawing, id: Some("r".to_owned()), size: Size::Zoom(2.0) };
    let (picture, _) = document.draw(&view, &Renderer::new(), Color::TRANSPARENT).unwrap();
    assert_eq!((picture.width(), picture.height()), (20, 10));
    assert!(picture.pixels().iter().all(|pixel| *pixel == GREEN));
    let unknown = View { id: Some("x".to_owned()), ..view };
    assert_eq!(
        document.draw(&unknown, &Renderer::new(), Color::WHITE).unwrap_err(),
        SvgError::UnknownId("x".to_owned())
    );
}

#[test]
fn triangles_of_three_colors_are_mixed() {
    let triangle = "<colortri points='0 0 40 0 0 40' colors='0 0 0 1 1 0 0 1 0 1 0 1'";
    let picture = draw(&format!("{triangle}/>"));
    for (x, y) in [(0u32, 0u32), (10, 10), (30, 5), (2, 35)] {
        let [r, g, b, a] = picture.pixels()[(y * 40 + x) as usize];
        let expected = |at: u32| (f64::from(at) + 0.5) / 40.0 * 255.0;
        assert!(
            (f64::from(r) - expected(x)).abs() < 1.0 && (f64::from(g) - expected(y)).abs() < 1.0,
            "{r} {g} at {x} {y}"
        );
        assert_eq!((b, a), (0, 255));
    }
    // Other attributes count, and so do copies.
    let copies = format!("<defs>{triangle} id='t' transform='scale(.5)'/></defs><use xlink:href='#t' x='20' y='20'/>");
    let copied = draw(&copies);
    assert_eq!(copied.pixels()[40 * 5 + 5], CLEAR);
    let [r, g, _, _] = copied.pixels()[40 * 21 + 30];
    assert!(r.abs_diff(134) <= 1 && g.abs_diff(19) <= 1, "{r} {g}");
}

#[test]
fn crisp_edges_leave_no_mixed_pixel() {
    let circle = |attributes: &str| draw(&format!("<circle cx='32' cy='32' r='25.3' fill='red' {attributes}/>"));
    let mixed = |picture: &Picture| picture.pixels().iter().filter(|pixel| ![0, 255].contains(&pixel[3])).count();
    let (smooth, crisp) = (circle(""), circle("shape-rendering='crispEdges'"));
    assert!(mixed(&smooth) > 50);
    assert_eq!(mixed(&crisp), 0);
    // A pixel is covered where its centre is: where it is covered more or less by half.
    for (smooth, crisp) in smooth.pixels().iter().zip(crisp.pixels()) {
        assert!(smooth[3].abs_diff(crisp[3]) <= 160, "{smooth:?} {crisp:?}");
    }
}

#[test]
fn plus_lighter_adds() {
    let group = |color: &str| {
        format!("<g style='mix-blend-mode:plus-lighter'><rect width='64' height='64' fill='{color}'/></g>")
    };
    let content = format!("{}{}", group("rgb(200,10,0)"), group("rgb(100,20,7)"));
    check(&content, &[(32, 32, [255, 30, 7, 255])]);
}

#[test]
fn what_is_not_drawn_is_named() {
    let document = parse("<foreignObject/><foreignObject/><rect><animate/></rect><script/>");
    let (_, warnings) = document.draw(&View::default(), &Renderer::new(), Color::WHITE).unwrap();
    let words: Vec<String> = warnings.iter().map(ToString::to_string).collect();
    assert_eq!(words.len(), 3, "{words:?}");
    assert!(words.iter().any(|text| text == "'foreignObject' is not drawn (2 times)"), "{words:?}");
}

#[test]
fn the_same_bytes_with_any_number_of_threads_and_at_every_level() {
    let document = parse(
        "<filter id='f'><feGaussianBlur stdDeviation='1.5'/><feDropShadow dx='2' dy='1' stdDeviation='0.7'/></filter>
         <radialGradient id='g'><stop stop-color='gold'/><stop offset='1' stop-color='navy' stop-opacity='.3'/></radialGradient>
         <pattern id='p' width='5' height='3' patternUnits='userSpaceOnUse' patternTransform='rotate(20)'><circle r='2' fill='teal'/></pattern>
         <g style='mix-blend-mode:multiply' opacity='.8'><ellipse cx='20' cy='18' rx='17' ry='9' fill='url(#g)' stroke='url(#p)' stroke-width='5'/></g>
         <g transform='rotate(15)' filter='url(#f)'><path d='M5 5q9 20 30 3T12 30z' fill='crimson' stroke='#000' stroke-dasharray='3 1'/></g>",
    );
    let view = View { size: Size::Width(173), ..View::default() };
    let draw = |threads, simd| {
        let renderer = Renderer { threads, simd, ..Renderer::new() };
        document.draw(&view, &renderer, Color::TRANSPARENT).unwrap().0
    };
    let first = draw(1, SimdLevel::detect());
    for simd in SimdLevel::ALL.into_iter().filter(|level| level.is_available()) {
        for threads in [1, 2, 3, 7] {
            assert!(draw(threads, simd) == first, "{} with {threads} threads", simd.name());
        }
    }
}

/// A folder with a TGA file of two texels, red and green.
fn folder_with_texture() -> std::path::PathBuf {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("svg_features");
    std::fs::create_dir_all(&folder).unwrap();
    let mut tga = [0; 18];
    (tga[2], tga[12], tga[14], tga[16], tga[17]) = (2, 2, 1, 24, 0x20);
    std::fs::write(folder.join("two.tga"), [&tga[..], &[0, 0, 255, 0, 128, 0]].concat()).unwrap();
    folder
}

#[test]
fn textures_of_triangles_are_read_as_asked() {
    let svg = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 40 40'><texture texid='t' filename='two.tga'/>
        <textri texid='t' points='0 0 80 0 0 80' uvs='0 0 4 0 0 4'/></svg>";
    let colors = |wrap, max_anisotropy| {
        let nearest = ImageFilter::new(PixelFilter::Nearest, LevelFilter::Zero);
        let triangle_filter = ImageFilter { wrap, max_anisotropy, ..nearest };
        let options = Options { folder: Some(folder_with_texture()), triangle_filter, ..Options::default() };
        let document = Document::parse(svg.as_bytes(), &options).unwrap();
        let (picture, warnings) = document.draw(&View::default(), &Renderer::new(), Color::TRANSPARENT).unwrap();
        assert!(warnings.is_empty(), "{warnings:?}");
        [5, 15, 25, 35].map(|x| picture.pixels()[5 * 40 + x])
    };
    assert_eq!(colors(Wrap::Repeat, 1), [RED, GREEN, RED, GREEN]);
    assert_eq!(colors(Wrap::Mirror, 8), [RED, GREEN, GREEN, RED]);
    assert_eq!(colors(Wrap::ClampToEdge, 1), [RED, GREEN, GREEN, GREEN]);
    assert_eq!(colors(Wrap::Border([0.0; 4]), 16), [RED, GREEN, CLEAR, CLEAR]);
}

#[test]
fn pictures_that_are_not_there_are_named() {
    let page = |link: &str| {
        format!(
            "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'><image href='{link}' width='9' height='9'/></svg>"
        )
    };
    for (link, folder, why) in [
        ("gone.png", Some(env!("CARGO_TARGET_TMPDIR").into()), "gone.png"),
        ("gone.png", None, "not read"),
        ("/dev/zero", Some(env!("CARGO_TARGET_TMPDIR").into()), "/dev/zero"),
        (".", Some(env!("CARGO_TARGET_TMPDIR").into()), "ordinary"),
        ("data:image/tiff;base64,AAAA", None, "embedded"),
        ("data:image/svg+xml,%3Csvg", None, "embedded"),
    ] {
        let document = Document::parse(page(link).as_bytes(), &Options { folder, ..Options::default() }).unwrap();
        let (_, warnings) = document.draw(&View::default(), &Renderer::new(), Color::TRANSPARENT).unwrap();
        assert!(warnings.iter().any(|warning| warning.message.contains(why)), "{link}: {warnings:?}");
    }
}

#[test]
fn fonts_that_are_not_there_are_named() {
    let document = parse("<text y='20' font-family='Nowhere'>a</text><text y='30' font-family='Nowhere'>b</text>");
    let (_, warnings) = document.draw(&View::default(), &Renderer::new(), Color::TRANSPARENT).unwrap();
    let [warning] = &warnings[..] else { panic!("{warnings:?}") };
    assert!(warning.message.contains("Nowhere") && warning.count == 2, "{warning:?}");
}
