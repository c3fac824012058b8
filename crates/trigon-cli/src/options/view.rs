//! Options about where the camera and the model stand.

use crate::values::{Angle, Positive, Scale, UpDirection, Vector};
use clap::Args;

#[derive(Debug, Args)]
#[command(next_help_heading = "View")]
pub(crate) struct ViewOptions {
    /// Position of the eye, instead of framing the model
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    pub(crate) eye: Option<Vector>,

    /// Point in the middle of the picture [default: middle of the model]
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    pub(crate) target: Option<Vector>,

    /// Direction that is up: an axis such as +Z, or x,y,z [default: +Y]
    ///
    /// In the coordinates of the model's file. For STL files the default is +Z.
    #[arg(long, value_name = "AXIS", allow_hyphen_values = true)]
    pub(crate) up: Option<UpDirection>,

    /// Angle around the model: 0 is the front, 90 its left [default: 35]
    ///
    /// The eye goes counterclockwise seen from above. With +Y up the front is +Z; with +Z up it is -Y.
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true, conflicts_with = "eye")]
    pub(crate) azimuth: Option<Angle>,

    /// Angle above the horizon: 90 looks straight down [default: 20]
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true, conflicts_with = "eye")]
    pub(crate) elevation: Option<Angle>,

    /// Magnification about the middle of the picture
    #[arg(long, value_name = "FACTOR", default_value = "1")]
    pub(crate) zoom: Positive,

    /// Vertical field of view, in degrees
    #[arg(long, value_name = "ANGLE", default_value = "35")]
    pub(crate) fov: Angle,

    /// Parallel projection; HEIGHT is that of the picture in the scene
    ///
    /// Without HEIGHT the model fills the picture, or with --eye what a perspective view shows at the target.
    #[arg(long, value_name = "HEIGHT", num_args = 0..=1, require_equals = true)]
    pub(crate) orthographic: Option<Option<Positive>>,

    /// Distance of the near plane [default: fitted to the model]
    #[arg(long, value_name = "DISTANCE", allow_hyphen_values = true)]
    pub(crate) near: Option<f64>,

    /// Distance of the far plane [default: fitted to the model]
    #[arg(long, value_name = "DISTANCE", allow_hyphen_values = true)]
    pub(crate) far: Option<f64>,

    /// Scale the model, by one factor or x,y,z
    #[arg(long, visible_alias = "model-scale", value_name = "FACTOR", allow_hyphen_values = true)]
    pub(crate) scale: Option<Scale>,

    /// Turn the model about the x axis, after scaling it
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    pub(crate) rotate_x: Option<Angle>,

    /// Turn the model about the y axis, after that
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    pub(crate) rotate_y: Option<Angle>,

    /// Turn the model about the z axis, after that
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    pub(crate) rotate_z: Option<Angle>,
}
