//! Position errors that real sensors cause on a scene, whatever the mechanization.

use sins::analysis::recommend::{Refusal, Track};
use sins::sensors::{self, StreamKey, TriadParameters};
use sins::{Options, Simulator};

use super::scene::{CurveScene, Pieces, Rate};
use crate::parallel::in_parallel;
use crate::progress::Progress;

/// Rate at which sensors with errors are flown [Hz]; the nearest rate of the scene is used.
const RATE_HZ: f64 = 100.0;

/// Gyros and accelerometers of a grade.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SensorPair {
    pub name: &'static str,
    gyro: TriadParameters,
    accel: TriadParameters,
}

/// Navigation and tactical grade, which are presets of the library. Each run draws its own biases.
pub fn grades() -> [SensorPair; 2] {
    [("navigation", sensors::Grade::Navigation), ("tactical", sensors::Grade::Tactical)].map(
        |(name, grade)| {
            let (gyro, accel) = grade.parameters();
            SensorPair { name, gyro, accel }
        },
    )
}

/// Largest position error on the way that each grade adds to the solution of ideal sensors; root mean square over `runs` [m].
pub fn effects(pieces: &Pieces, runs: u64) -> Result<[f64; 2], Refusal> {
    let flown = match (&pieces.coarse, pieces.scenes.first()) {
        (Some((rate, samples)), Some(scene)) => {
            let instants = CurveScene::instants(samples.len(), &[*rate], 1);
            Some((scene, *rate, samples.clone(), instants))
        }
        (None, Some(scene)) => {
            let nearest = scene.rates.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
            nearest.map(|rate| (scene, *rate, scene.samples_at(rate), scene.instants_at(rate)))
        }
        (_, None) => None,
    };
    let Some((scene, rate, samples, instants)) = flown else { return Ok([0.0; 2]) };
    let ideal = SensorPair { name: "ideal", gyro: Default::default(), accel: Default::default() };
    let [navigation, tactical] = grades();
    let mut flights = vec![(ideal, 0)];
    flights.extend((1..=runs).map(|run| (navigation, run)).chain((1..=runs).map(|run| (tactical, run))));
    let what = format!("{}: flying sensors with errors", scene.name);
    let progress = Progress::flying(what, samples.len() * flights.len(), false);
    let tracks = in_parallel(&flights, |(grade, run)| {
        let key = StreamKey { run: *run, ..Default::default() };
        let mut simulator = Simulator::new(&rate.applied_to(&Options { key, ..scene.base }))?;
        simulator.set_gyro(&grade.gyro)?;
        simulator.set_accel(&grade.accel)?;
        let track = sins::analysis::recommend::track(&mut simulator, &samples, &instants);
        progress.fly(samples.len(), 1.0 / rate.hz);
        track
    });
    let tracks = tracks.into_iter().collect::<Result<Vec<Track>, Refusal>>()?;
    let (ideal, noisy) = (&tracks[0], &tracks[1..]);
    let rms = |tracks: &[Track]| {
        let squares = tracks.iter().map(|track| track.minus(ideal).position_m.powi(2));
        (squares.sum::<f64>() / tracks.len() as f64).sqrt()
    };
    let (navigation, tactical) = noisy.split_at(runs as usize);
    Ok([rms(navigation), rms(tactical)])
}

fn distance(rate: &Rate) -> f64 {
    (rate.hz / RATE_HZ).ln().abs()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::embedded;

    /// Two minutes at rest: an accelerometer bias of 1e-5 g is compared with a bias of 1e-3 g.
    #[test]
    fn better_sensors_err_less() {
        let scene = embedded::ALL[0].scene(120.0).unwrap();
        let [navigation, tactical] = effects(&Pieces::whole(scene), 4).unwrap();
        // ½ a t² is 0.7 m for a = 1e-5 g. The second axis and the random bias change it by a factor.
        assert!(navigation > 0.1 && navigation < 7.0, "{navigation}");
        assert!(tactical > 20.0 * navigation && tactical < 1e3, "{tactical}");
    }
}
