//! For the tests: a plain sampler in double precision, one point at a time, by the definitions.

use super::{LevelFilter, PixelFilter, Sampler, Texture, Wrap};

/// One point and its derivatives.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point {
    pub(super) uv: [f64; 2],
    pub(super) ddx: [f64; 2],
    pub(super) ddy: [f64; 2],
}

/// The sample, or nothing if it hangs by rounding on which side of a texel border or level border something lies.
/// Isotropic.
pub(super) fn sample(texture: &Texture, sampler: &Sampler, point: &Point) -> Option<[f64; 4]> {
    let lod = lod(texture, sampler, point);
    match sampler.level {
        LevelFilter::Zero => sample_level(texture, sampler, point.uv, 0),
        LevelFilter::Nearest => {
            let level = decided_floor(lod + 0.5)?;
            sample_level(texture, sampler, point.uv, level as usize)
        }
        LevelFilter::Linear => {
            let level = lod.floor();
            let below = sample_level(texture, sampler, point.uv, level as usize)?;
            let above = sample_level(texture, sampler, point.uv, (level as usize + 1).min(texture.levels() - 1))?;
            Some(mix(below, above, lod - level))
        }
    }
}

pub(super) fn lod(texture: &Texture, sampler: &Sampler, point: &Point) -> f64 {
    if sampler.level == LevelFilter::Zero {
        return 0.0;
    }
    let [width, height] = texture.desc().size.map(f64::from);
    let length = |d: [f64; 2]| (square(d[0] * width) + square(d[1] * height)).sqrt();
    let rho = length(point.ddx).max(length(point.ddy));
    let last = (texture.levels() - 1) as f64;
    let low = f64::from(sampler.lod_min).clamp(0.0, last);
    let high = f64::from(sampler.lod_max).clamp(0.0, last);
    (libm::log2(rho) + f64::from(sampler.lod_bias)).max(low).min(high)
}

fn square(x: f64) -> f64 {
    x * x
}

fn sample_level(texture: &Texture, sampler: &Sampler, uv: [f64; 2], level: usize) -> Option<[f64; 4]> {
    let size = texture.level_size(level).expect("the level exists");
    let scaled = [uv[0] * f64::from(size[0]), uv[1] * f64::from(size[1])];
    let texel = |x: f64, y: f64| {
        let (column, row) = (wrap(sampler.wrap_u, x as i64, size[0]), wrap(sampler.wrap_v, y as i64, size[1]));
        let (column, row) = match (column, row) {
            (Err(border), _) | (_, Err(border)) => return border.map(f64::from),
            (Ok(column), Ok(row)) => (column, row),
        };
        texture.texel(level, column, row).expect("the texel exists").map(f64::from)
    };
    if sampler.pixel == PixelFilter::Nearest {
        return Some(texel(decided_floor(scaled[0])?, decided_floor(scaled[1])?));
    }
    let [x, y] = scaled.map(|t| t - 0.5);
    let (x0, y0) = (x.floor(), y.floor());
    let top = mix(texel(x0, y0), texel(x0 + 1.0, y0), x - x0);
    let bottom = mix(texel(x0, y0 + 1.0), texel(x0 + 1.0, y0 + 1.0), x - x0);
    Some(mix(top, bottom, y - y0))
}

/// The texel of the image, or the border colour.
fn wrap(wrap: Wrap, texel: i64, size: u32) -> Result<u32, [f32; 4]> {
    let n = i64::from(size);
    let inside = match wrap {
        Wrap::Repeat => texel.rem_euclid(n),
        Wrap::Mirror => {
            let t = texel.rem_euclid(2 * n);
            t.min(2 * n - 1 - t)
        }
        Wrap::ClampToEdge => texel.clamp(0, n - 1),
        Wrap::Border(colour) if texel < 0 || texel >= n => return Err(colour),
        Wrap::Border(_) => texel,
    };
    Ok(u32::try_from(inside).expect("inside the image"))
}

fn decided_floor(x: f64) -> Option<f64> {
    let clear = 1e-4;
    ((x + clear).floor() == (x - clear).floor()).then(|| x.floor())
}

fn mix(a: [f64; 4], b: [f64; 4], t: f64) -> [f64; 4] {
    core::array::from_fn(|c| a[c] + t * (b[c] - a[c]))
}
