//! Deadlines: work ends soon after the moment, with an error and without half a picture; a moment that is far away
//! changes nothing.

use std::fmt::Write as _;
use std::time::{Duration, Instant};

use trigon::schedule::Deadline;
use trigon_image::Color;
use trigon_svg::canvas::{BlendMode, DrawError, Drawing, FillRule, Path, Picture, Renderer, Transform};
use trigon_svg::svg::{Document, Options, SvgError, View};

/// Takes a second or more to draw: shapes over each other, blended sample by sample.
fn slow_drawing() -> Drawing {
    let mut drawing = Drawing::new();
    let circle = std::sync::Arc::new(Path::circle(500.0, 500.0, 480.0));
    for _ in 0..20_000 {
        drawing.fill(circle.clone(), FillRule::NonZero, Transform::IDENTITY, Color::BLACK, 0.5, BlendMode::Hue);
    }
    drawing
}

fn renderer(deadline: Deadline) -> Renderer {
    Renderer { threads: 2, deadline, ..Renderer::new() }
}

fn parse(svg: &str) -> Document {
    Document::parse(svg.as_bytes(), &Options::default()).unwrap()
}

#[test]
fn drawing_ends_soon_after_the_moment() {
    let drawing = slow_drawing();
    let started = Instant::now();
    let drawn = renderer(Deadline::after(Duration::from_millis(50))).draw(&drawing, 1000, 1000, Color::WHITE);
    assert_eq!(drawn, Err(DrawError::TimeOver));
    let took = started.elapsed();
    assert!(took >= Duration::from_millis(50) && took < Duration::from_secs(10), "{took:?}");
}

#[test]
fn no_half_picture_is_left() {
    let drawing = slow_drawing();
    let before = Renderer::new().draw(&Drawing::new(), 1000, 1000, Color::WHITE).unwrap();
    let soon = || renderer(Deadline::after(Duration::from_millis(50)));
    let mut picture = before.clone();
    assert_eq!(soon().draw_over(&drawing, &mut picture), Err(DrawError::TimeOver));
    assert!(picture == before, "what was there is still there");
    assert_eq!(soon().draw_into(&drawing, Color::WHITE, &mut picture), Err(DrawError::TimeOver));
    assert!(picture.pixels().iter().all(|pixel| *pixel == [0; 4]));
}

#[test]
fn a_far_moment_changes_nothing() {
    let mut drawing = Drawing::new();
    let circle = Path::circle(30.0, 30.0, 20.5);
    drawing.fill(circle, FillRule::NonZero, Transform::IDENTITY, Color::BLACK, 0.7, BlendMode::Normal);
    let (free, timed) = (renderer(Deadline::NEVER), renderer(Deadline::after(Duration::from_secs(3600))));
    let picture = free.draw(&drawing, 64, 64, Color::WHITE).unwrap();
    assert!(timed.draw(&drawing, 64, 64, Color::WHITE).unwrap() == picture);
    let over = |renderer: &Renderer| -> Picture {
        let mut picture = picture.clone();
        renderer.draw_over(&drawing, &mut picture).unwrap();
        picture
    };
    assert!(over(&timed) == over(&free));
}

#[test]
fn a_filter_is_given_up_in_its_middle() {
    let weights = "1 ".repeat(63 * 63);
    let svg = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' width='2000' height='2000'>
         <filter id='f'><feConvolveMatrix order='63' kernelMatrix='{weights}'/></filter>
         <rect width='2000' height='2000' filter='url(#f)'/></svg>"
    );
    for turn in ["", "transform='rotate(10)'"] {
        let document = parse(&svg.replace("<rect", &format!("<rect {turn}")));
        let started = Instant::now();
        let drawn =
            document.draw(&View::default(), &renderer(Deadline::after(Duration::from_millis(100))), Color::WHITE);
        assert!(matches!(drawn, Err(SvgError::Draw(DrawError::TimeOver))), "{turn}");
        // All of it would take a hundred times as long as it is allowed to.
        assert!(started.elapsed() < Duration::from_secs(2), "{turn} {:?}", started.elapsed());
    }
}

/// A drawing that was prepared is drawn under the deadline of the one who draws it, filters included.
#[test]
fn filters_have_the_deadline_of_who_draws() {
    let svg = "<svg xmlns='http://www.w3.org/2000/svg' width='400' height='400'>
        <filter id='f'><feImage href='#a'/><feGaussianBlur stdDeviation='3'/></filter>
        <defs><circle id='a' cx='200' cy='200' r='90' fill='red'/></defs>
        <rect width='400' height='400' filter='url(#f)'/></svg>";
    let document = parse(svg);
    let draw = |prepare: Duration, draw: Deadline| {
        let prepared = document.prepare(&View::default(), &renderer(Deadline::after(prepare))).unwrap();
        std::thread::sleep(Duration::from_millis(20));
        renderer(draw).draw(&prepared.drawing, 400, 400, Color::WHITE)
    };
    let hour = Duration::from_secs(3600);
    let whole = draw(hour, Deadline::NEVER).unwrap();
    assert!(whole.pixels()[200 * 400 + 200] != whole.pixels()[0]);
    assert_eq!(draw(hour, Deadline::after(Duration::ZERO)), Err(DrawError::TimeOver));
    // The time of preparing is over, but not that of drawing.
    let soon = Duration::from_millis(15);
    match document.prepare(&View::default(), &renderer(Deadline::after(soon))) {
        Ok(prepared) => {
            std::thread::sleep(soon);
            assert!(renderer(Deadline::NEVER).draw(&prepared.drawing, 400, 400, Color::WHITE).unwrap() == whole);
        }
        Err(error) => assert_eq!(error, SvgError::Draw(DrawError::TimeOver), "on a machine that is busy"),
    }
}

#[test]
fn reading_looks_at_the_clock() {
    let svg = "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'/>";
    let options = Options { deadline: Deadline::after(Duration::ZERO), ..Options::default() };
    assert_eq!(Document::parse(svg.as_bytes(), &options).unwrap_err(), SvgError::TimeOver);
    let options = Options { deadline: Deadline::after(Duration::from_secs(3600)), ..Options::default() };
    assert!(Document::parse(svg.as_bytes(), &options).is_ok());
}

#[test]
fn many_shapes_are_given_up_in_their_midst() {
    let mut svg = String::from("<svg xmlns='http://www.w3.org/2000/svg' width='4000' height='4000'>");
    for i in 0..20_000 {
        write!(svg, "<path stroke='red' fill='none' stroke-dasharray='0.3' d='M{i} 0Q0 4000 4000 {i}'/>").unwrap();
    }
    let document = parse(&(svg + "</svg>"));
    let started = Instant::now();
    let prepared = document.prepare(&View::default(), &renderer(Deadline::NEVER)).unwrap();
    let deadline = Deadline::after(Duration::from_millis(200));
    assert_eq!(renderer(deadline).draw(&prepared.drawing, 4000, 4000, Color::WHITE), Err(DrawError::TimeOver));
    assert!(started.elapsed() < Duration::from_secs(10), "{:?}", started.elapsed());
}
