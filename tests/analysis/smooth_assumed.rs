//! What an assumed attitude costs an INS: the figures of the note of a log without an attitude.

use nalgebra::Vector3;
use sins::earth::Earth;
use sins::log::smooth::{ASSUMED_ATTITUDE_COSTS, SmoothOptions, Smoothed};
use sins::math::Euler;
use sins::scene::Scene;
use sins::sensors::Grade;

use crate::judge::faults::noisy;
use crate::judge::flights::{Good, Samples, aeroplane_in_wind, glider_in_thermals, vehicle};
use crate::smooth_cep::radii;

const RUNS: usize = 50;

/// Turns of 25 degrees to both sides for a while each, in calm air, with an angle of attack.
fn aeroplane() -> Good {
    vehicle("aeroplane", 50.0, |t| {
        let turn = 0.075 * (0.021 * t).sin().powi(3);
        let heading = 0.3 + 0.075 / 0.021 * ((0.021 * t).cos().powi(3) / 3.0 - (0.021 * t).cos());
        let v = Vector3::new(60.0 * heading.sin(), 60.0 * heading.cos(), 2.0 * (0.02 * t).sin());
        (v, Euler { roll: (60.0 * turn / 9.81).atan(), pitch: 0.05, heading })
    })
}

/// It flies forward, stops, turns over one place, flies sideways, and turns on.
fn helicopter() -> Good {
    vehicle("helicopter", 50.0, |t| {
        let eased = |begin_s: f64, end_s: f64| {
            let x = ((t - begin_s) / (end_s - begin_s)).clamp(0.0, 1.0);
            x * x * x * (10.0 - 15.0 * x + 6.0 * x * x)
        };
        let during = |begin_s: f64, end_s: f64| eased(begin_s, begin_s + 10.0) - eased(end_s - 10.0, end_s);
        let heading = 0.5 + 2.5 * eased(150.0, 180.0) - 1.8 * eased(330.0, 360.0);
        let (forward, right) =
            (30.0 * during(20.0, 130.0) + 25.0 * during(400.0, 560.0), 4.0 * during(200.0, 320.0));
        let (sine, cosine) = heading.sin_cos();
        let v = Vector3::new(forward * sine + right * cosine, forward * cosine - right * sine, 0.0);
        (v, Euler { roll: 0.02 * (0.7 * t).sin(), pitch: -0.002 * forward, heading })
    })
}

#[test]
fn the_note_of_a_log_without_attitude_says_what_it_costs() {
    let grades = [Grade::Navigation, Grade::Industrial];
    let [of_aeroplanes, of_gliders, of_hovering] = ASSUMED_ATTITUDE_COSTS;
    let classes = [
        (vec![aeroplane(), aeroplane_in_wind(50.0)], 1.0 - of_aeroplanes, 1.0 + of_aeroplanes),
        (vec![glider_in_thermals(50.0)], 1.0 - of_gliders, 1.0 + of_gliders),
        (vec![helicopter()], 1.0 / of_hovering, of_hovering),
    ];
    for (flights, least, most) in classes {
        let mut ratios = Vec::new();
        for flight in flights {
            let rows = noisy(&flight.at(1.0), 1.5);
            let options = SmoothOptions { coordinated_attack_rad: Some(0.0), ..SmoothOptions::default() };
            let path = Smoothed::new(&Earth::default(), &rows, &options).unwrap();
            let [start_s, end_s] = path.span_s();
            let truth: Samples =
                flight.samples.iter().filter(|at| (start_s..=end_s).contains(&at.time_s)).copied().collect();
            let smoothed: Samples = truth.iter().map(|at| path.sample_at(at.time_s).unwrap()).collect();
            for grade in grades {
                let [of_path, of_truth] = [&smoothed, &truth].map(|samples| radii(samples, grade, RUNS));
                let both = [0, 1].map(|place| of_path[place] / of_truth[place]);
                println!("{} {grade:?}: CEP50 {:.1} m, times {both:.3?}", flight.name, of_truth[0]);
                ratios.extend(both);
            }
        }
        let held = ratios.iter().filter(|ratio| (least..=most).contains(*ratio)).count();
        assert!(10 * held >= 9 * ratios.len(), "{held} of {}: {ratios:.3?}", ratios.len());
    }
}

/// The note, in the document in the words of the note.
#[test]
fn the_document_says_it_in_the_words_of_the_note() {
    let table: String =
        (0..200).map(|k| format!("{k},{:.8},8,{}\n", 47.0 + 5e-4 * f64::from(k), 500 + k)).collect();
    let scene = Scene::parse(b"[flight]\nfile = \"a\"\n[log]\nattitude = \"coordinated\"\n").unwrap();
    let table = format!("time_s,latitude_deg,longitude_deg,height_m\n{table}");
    let log = scene.read_log(table.as_bytes()).unwrap();
    let note = log.notes().iter().find(|note| note.sentence.starts_with("attitude: assumed")).unwrap();
    let document = include_str!("../../docs/your_log.md").split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(document.contains(&note.sentence), "{}", note.sentence);
}
