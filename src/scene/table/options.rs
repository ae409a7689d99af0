//! The simulator and what a program writes: `[options]`, `[output]`.

use super::super::key::{Key, Place, Section, Target, one};
use super::{choice, count, number, si, text};
use crate::base::parameter::Shape;
use crate::earth::state::BodyAxes;
use crate::earth::{Ellipsoid, GravityModel};
use crate::mechanization::{Frame, Scheme, VerticalMode};
use crate::simulator::Options;

const O: Section = Section::Options;
const P: Section = Section::Output;
const N: Shape = Shape::Number;
const SWITCH: [(&str, bool); 2] = [("off", false), ("on", true)];

pub const OPTIONS: &[Key] = &[
    choice!(O, "scheme", "algorithm of the mechanization", "options.scheme" => scene.options.scheme, Scheme::WORDS),
    choice!(O, "frame", "axes of the mechanization", "options.frame" => scene.options.frame, Frame::WORDS),
    count!(O, "subsamples", "subsamples of an update, 1 to 5", "options.subsamples" in Options::SUBSAMPLES => scene.options.subsamples),
    count!(O, "updates_per_sample", "updates in a sample interval, 1 to 16", "options.updates_per_sample" in Options::UPDATES => scene.options.updates_per_sample),
    choice!(O, "vertical", "vertical channel", "options.vertical" => scene.options.vertical, VerticalMode::WORDS),
    choice!(O, "error_model", "error differential equations (error data 1)", "options.error_model" => scene.options.error_model, [("off", false), ("rk4", true)]),
    choice!(O, "truth_summary", "summary of the true motion", "options.truth_summary" => scene.options.truth_summary, SWITCH),
    choice!(O, "covariance", "covariance of the errors", "options.covariance" => scene.options.covariance, SWITCH),
    choice!(O, "earth", "ellipsoid", "options.earth" => scene.options.ellipsoid, Ellipsoid::WORDS),
    choice!(O, "gravity", "normal gravity", "options.gravity" => scene.options.gravity, GravityModel::WORDS),
    choice!(O, "axes", "sensor axes: right-forward-up or forward-right-down", "options.axes" => scene.options.axes, BodyAxes::WORDS),
    choice!(O, "signal", "ideal signals: physical, or with a trim that keeps an error-free navigator at the truth",
        "options.signal" => closed_loop, [("physical", false), ("closed-loop", true)]),
    number!(O, N, "closed_loop_time_s", si("s"), "time constant of the trim",
        "options.closed_loop_time_s" in Options::CLOSED_LOOP_TIMES_S => one(closed_loop_time_s)),
    count!(O, "seed", "seed of all random streams", "options.seed" => scene.options.key.seed),
    count!(O, "run", "number of the run in an ensemble", "options.run" => scene.options.key.run),
    number!(O, N, "sample_period_s", si("s"), "stated sample period of a log; default: the time stamps of the log",
        "options.sample_period_s" in Options::INTERVALS_S => one(sample_period_s)),
    number!(O, N, "max_gap_s", si("s"), "longest interval between samples",
        "options.max_gap_s" in Options::INTERVALS_S => one(scene.options.intake.max_gap_s)),
    number!(O, N, "max_acceleration_m_s2", si("m/s2"),
        "largest mean acceleration between two samples, also of velocities derived from a log; more is rejected as a jump",
        "options.max_acceleration_m_s2" in Options::ACCELERATIONS_M_S2 => one(scene.options.intake.max_acceleration_m_s2)),
];

pub const OUTPUT: &[Key] = &[
    text(P, "folder", "sins_out", "folder of the output files", |d| &mut d.scene.output.folder),
    text(P, "name", "patrol", "base name of the output files; default from the scene", |d| {
        &mut d.scene.output.name
    }),
    text(P, "imu", "imu.csv", "file of the measured increments on which the INS navigates", |d| {
        &mut d.scene.output.imu
    }),
    number!(P, N, "every_s", si("s"), "time between two records; default: about 2000 records",
        "output.every_s" in (5e-5, 1e7) => one(every_s)),
    Key::new(
        P,
        "quiet",
        "shows neither progress nor summary",
        Target::Flag { get: |d| d.scene.output.quiet, set: |d, quiet| d.scene.output.quiet = quiet },
    ),
];
