//! Random scenes as texts, each with a part of what a scene can plan: unit, panel, updates, failures, temperature, a log. The same seed
//! gives the same scene.

use sins::records::Number;
use sins::scene::Scene;

use super::draws::Draws;

/// Time flown [s].
const SECONDS: usize = 120;
const RATE_HZ: usize = 10;

/// The text of a scene, and of its log, if its flight is one.
pub struct RandomScene {
    pub text: String,
    pub log: Option<String>,
}

impl Draws {
    /// A time of the flight in quarters of a second, which are not all at samples.
    fn time_s(&mut self) -> f64 {
        self.below(4 * SECONDS) as f64 / 4.0
    }
}

/// The scene of `seed`. `with_log`: its flight may be a log.
pub fn random_scene(seed: u64, with_log: bool) -> RandomScene {
    let mut draws = Draws::new(seed);
    let rest_s = 10 + draws.below(60);
    let flight = format!(
        "[flight]\nlatitude_deg = {}\nlongitude_deg = {}\nheight_m = {}\nheading_deg = {}\nrate_hz = {RATE_HZ}\n",
        draws.below(120) as f64 - 60.0,
        draws.below(360) as f64 - 180.0,
        draws.below(3000),
        draws.below(360)
    );
    let manoeuvres = format!(
        "[[manoeuvre]]\nkind = \"rest\"\nduration_s = {rest_s}\n[[manoeuvre]]\nkind = \"accelerate\"\nduration_s = 20\n\
         speed_change_m_s = {}\n[[manoeuvre]]\nkind = \"straight\"\nduration_s = {}\n",
        30 + draws.below(40),
        SECONDS - 20 - rest_s
    );
    let log = (with_log && draws.one_in(3)).then(|| log_of(&format!("{flight}{manoeuvres}"), &mut draws));
    let mut text = match &log {
        Some(_) => "[flight]\nfile = \"random.csv\"\n".to_owned(),
        None => flight,
    };
    if draws.one_in(2) {
        let change = draws.below(900);
        text += &format!("temperature_c = 15\ntemperature_change_c_h = {change}\n");
    }
    text += &format!("[options]\nseed = {seed}\nrun = {}\n", draws.below(1000));
    if log.is_none() {
        text += &manoeuvres;
    }
    let grade = draws.of(&["navigation", "tactical", "industrial"]);
    text += &format!(
        "[gyro]\npreset = \"{grade}\"\n[accelerometer]\npreset = \"{grade}\"\n[start]\npreset = \"{grade}\"\n"
    );
    for kind in ["position", "horizontal_position", "velocity"] {
        if draws.one_in(2) {
            let sigma = if kind == "velocity" { "sigma_m_s = 0.2" } else { "sigma_m = 30" };
            let every = 1 + draws.below(40);
            text += &format!(
                "[[update]]\nkind = \"{kind}\"\nat_s = {}\nevery_s = {every}\n{sigma}\n",
                0.25 + draws.time_s()
            );
        }
    }
    for (sensor, axis) in [("gyro", "axis = \"x\"\n"), ("accelerometer", "axis = \"z\"\n"), ("altimeter", "")]
    {
        if draws.one_in(2) {
            let from_s = draws.time_s();
            let kind = draws.of(&["stuck", "dead", "drop_outs"]);
            let more = if kind == "drop_outs" { "interval_s = 2\n" } else { "" };
            text += &format!(
                "[[failure]]\nsensor = \"{sensor}\"\n{axis}kind = \"{kind}\"\n{more}from_s = {from_s}\nuntil_s = {}\n",
                from_s + 0.3 + draws.below(8) as f64
            );
        }
    }
    if draws.one_in(2) {
        text += &unit(&mut draws);
    }
    RandomScene { text, log }
}

/// A unit and its panel. Some of the entries come at a moment at which the unit does not take them.
fn unit(draws: &mut Draws) -> String {
    let kind = draws.of(&["gyrocompass", "fast", "instant", "in_flight"]);
    let mut text = format!(
        "[unit]\nstart = \"{}\"\nalignment = \"{kind}\"\npower_up_test_s = 2\n",
        draws.of(&["off", "off", "nav"])
    );
    let mut action =
        |kind: &str, at_s: f64| text += &format!("[[panel]]\nkind = \"{kind}\"\nat_s = {at_s}\n");
    action("align", 1.0);
    action("true_position", 4.0 + 0.25 * draws.below(8) as f64);
    action(draws.of(&["nav", "att"]), 6.0 + draws.time_s());
    for _ in 0..draws.below(3) {
        let kind = draws.of(&[
            "off",
            "align",
            "nav",
            "true_position",
            "battery",
            "no_power",
            "aircraft_power",
            "test",
        ]);
        action(kind, draws.time_s());
    }
    text
}

/// The flight of a scene as a log whose time stamps do not begin at 0 and are not quite regular.
fn log_of(scene: &str, draws: &mut Draws) -> String {
    let scene = Scene::parse(scene.as_bytes()).unwrap_or_else(|faults| panic!("{faults:?}"));
    let flight = scene.flight().unwrap();
    let start_s = draws.below(100_000) as f64;
    let mut text =
        "time_s,latitude_rad,longitude_rad,height_m,velocity_east_m_s,velocity_north_m_s,velocity_up_m_s,\
                    roll_rad,pitch_rad,heading_rad\n"
            .to_owned();
    for k in 0..=SECONDS * RATE_HZ {
        let time_s = (k as f64 + 0.1 * draws.below(3) as f64) / RATE_HZ as f64;
        let sample = flight.sample_at(time_s.min(flight.duration_s())).unwrap();
        if k > 0 && time_s > flight.duration_s() {
            break;
        }
        let (place, v, euler) = (sample.place, sample.v_n.unwrap(), sample.euler);
        let values = [
            start_s + time_s,
            place.latitude_rad,
            place.longitude_rad,
            place.height_m,
            v.x,
            v.y,
            v.z,
            euler.roll,
            euler.pitch,
            euler.heading,
        ];
        let fields: Vec<String> = values.iter().map(|value| Number(*value).to_string()).collect();
        text += &fields.join(",");
        text.push('\n');
    }
    text
}
