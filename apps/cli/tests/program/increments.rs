//! The file of the measured increments: a navigator on them has the solution of the flight.

use sins::mechanization::VerticalMode;
use sins::scene::builtin;
use sins::signal::Increment;
use sins::{Options, Simulator};

use crate::support::{done, folder, number, rows};

/// Sensors with errors, and no aid of the vertical channel.
const SETTINGS: [&str; 5] = [
    "options.vertical=free",
    "gyro.bias_sigma_deg_h=1",
    "gyro.random_walk_deg_sqrt_h=0.1",
    "accelerometer.bias_sigma_micro_g=100",
    "flight.hours=0.01",
];

#[test]
fn the_increments_of_a_flight_navigate_to_its_bits() {
    for (name, subsamples, updates) in [("aerobatics", 2, 1), ("coning", 3, 2), ("coning", 1, 1)] {
        let folder = folder(&format!("{name}_{subsamples}"));
        let scheme = [("subsamples", subsamples), ("updates_per_sample", updates)]
            .map(|(key, count)| format!("options.{key}={count}"));
        let mut arguments = vec!["fly", name, "--quiet", "--imu", "imu.csv", "--set", "output.every_s=0.01"];
        for setting in SETTINGS.into_iter().chain(scheme.iter().map(String::as_str)) {
            arguments.extend(["--set", setting]);
        }
        done(&folder, &arguments);

        let flight = builtin(name).unwrap().flight().unwrap();
        let start = flight.sample_at(0.0).unwrap();
        let options = Options { vertical: VerticalMode::Free, ..Options::default() };
        let mut own = Simulator::new(&options).unwrap();
        own.push_sample(&start).unwrap();
        let truth = own.truth().unwrap().unwrap();
        own.reset();
        own.start_navigation(truth.time_s, &truth.navigation).unwrap();

        let records = rows(&folder.join(format!("sins_out/{name}.csv")));
        let mut expected = records.iter().skip(1);
        let mut increments = Vec::new();
        let mut parts = 0;
        for row in rows(&folder.join("sins_out/imu.csv")) {
            let three = |quantity: &str, unit: &str| {
                ["x", "y", "z"]
                    .map(|axis| number(&row, &format!("{quantity}_increment_{axis}_{unit}")))
                    .into()
            };
            increments.push(Increment { angle: three("angle", "rad"), velocity: three("velocity", "m_s") });
            assert_eq!(number(&row, "part"), increments.len() as f64);
            if number(&row, "part") == number(&row, "parts") {
                own.push_imu(&increments, number(&row, "update_s")).unwrap();
                increments.clear();
            }
            parts += 1;
            if parts % (subsamples * updates) == 0 {
                let record = expected.next().unwrap();
                assert_eq!(number(&row, "time_s"), number(record, "time_s"));
                let navigation = own.navigation().unwrap().unwrap().navigation;
                for (quantity, found) in [
                    ("latitude_rad", navigation.place.latitude_rad),
                    ("longitude_rad", navigation.place.longitude_rad),
                    ("height_m", navigation.place.height_m),
                    ("velocity_east_m_s", navigation.v_n.x),
                    ("velocity_north_m_s", navigation.v_n.y),
                    ("velocity_up_m_s", navigation.v_n.z),
                    ("roll_rad", navigation.euler.roll),
                    ("pitch_rad", navigation.euler.pitch),
                    ("heading_rad", navigation.euler.heading),
                ] {
                    assert_eq!(
                        found,
                        number(record, &format!("navigation_{quantity}")),
                        "{name}: {quantity}"
                    );
                }
            }
        }
        assert_eq!((expected.next(), parts), (None, 3600 * subsamples * updates));
    }
}
