mod support;
use nalgebra::Vector3;
use sins::sensors::{Grade, TriadParameters};
use sins::{Options, Simulator};
#[test]
fn speed() {
    let flight = support::patrol(700.0);
    let aero = sins::scene::builtin("aerobatics").unwrap().flight().unwrap();
    for (name, flight) in [("patrol", &flight), ("aerobatics", &aero)] {
        let n = 30000;
        let samples: Vec<_> = (0..n).map(|k| flight.sample_at(0.01 * f64::from(k)).unwrap()).collect();
        let (gyro, accel) = Grade::Navigation.parameters();
        let flicker = |t: TriadParameters, s: f64| TriadParameters { flicker: Vector3::repeat(s), ..t };
        for (what, gyro, accel) in
            [("navigation", gyro, accel), ("with flicker", flicker(gyro, 1e-9), flicker(accel, 1e-5))]
        {
            let mut best = [f64::MAX; 3];
            for _ in 0..7 {
                for (k, (covariance, error_model)) in
                    [(false, false), (true, false), (false, true)].into_iter().enumerate()
                {
                    let mut s =
                        Simulator::new(&Options { covariance, error_model, ..Options::default() }).unwrap();
                    s.set_gyro(&gyro).unwrap();
                    s.set_accel(&accel).unwrap();
                    let t = std::time::Instant::now();
                    for sample in &samples {
                        s.push_sample(sample).unwrap();
                        s.step().unwrap();
                    }
                    best[k] = best[k].min(t.elapsed().as_secs_f64() / f64::from(n) * 1e9);
                }
            }
            let mut s = Simulator::new(&Options { covariance: true, ..Options::default() }).unwrap();
            s.set_gyro(&gyro).unwrap();
            s.set_accel(&accel).unwrap();
            for sample in &samples[..1050] {
                s.push_sample(sample).unwrap();
                s.step().unwrap();
            }
            let t = std::time::Instant::now();
            for _ in 0..1000 {
                std::hint::black_box(s.covariance().unwrap());
            }
            println!(
                "{name} {what}: off {:.0} on {:.0} model {:.0} ns a step; read {:.0} ns",
                best[0],
                best[1],
                best[2],
                t.elapsed().as_secs_f64() * 1e6
            );
        }
    }
}
