//! The clock jumps. After `move_time` a flight continues to the same bits, at any valid time.

use sins::mechanization::{Frame, VerticalMode};
use sins::truth::{FlightSample, IntakeLimits, Pushed};
use sins::{ErrorSource, Options, Simulator, Step};

use super::troubled;
use crate::support::moments::{reads, snapshot};
use crate::support::{errors, fly_through, patrol, resting_sample};

/// Everything that is read except for times.
fn without_times(simulator: &Simulator) -> String {
    let solution =
        |solution: sins::Solution| (solution.navigation, solution.near_pole, solution.vertical_unaided);
    let imu = simulator.imu().map(|imu| (imu.interval_s, imu.ideal, imu.measured, imu.flags));
    let model = simulator.errors(ErrorSource::Model).map(|errors| errors.map(|(_, errors)| errors));
    format!(
        "{:?}",
        (
            simulator.truth().unwrap().map(solution),
            simulator.navigation().unwrap().map(solution),
            (imu, errors(simulator, ErrorSource::Navigation), model, simulator.intervals()),
        )
    )
}

/// The clock advances by hours, or jumps by decades and back, with samples in the queue. Each later read equals, to the bit, that
/// of a flight whose stamps never jumped. Stamps at 128 Hz are exact up to 2^46 s; with a stated period, intervals are not
/// differences of stamps.
#[test]
fn a_pause_that_is_moved_leaves_no_bit_behind() {
    let flight = patrol(1200.0);
    let stated = IntakeLimits { period_s: Some(0.01), ..Default::default() };
    let model = Options { error_model: true, ..Options::default() };
    let closed = Options { closed_loop_time_s: Some(20.0), frame: Frame::Geographic, ..model };
    let cases = [
        (model, 1.0 / 128.0, 0.0, true),
        (closed, 1.0 / 128.0, 0.0, true),
        (Options { vertical: VerticalMode::Free, ..model }, 1.0 / 128.0, 0.0, false),
        // With a stated period, stamps deviate from it by up to 0.15 of the period.
        (Options { intake: stated, ..model }, 0.01, 0.15, true),
    ];
    for (options, period_s, jitter, with_velocity) in cases {
        let sample = |k: usize| {
            let mut sample = flight.sample_at(300.0 + k as f64 * period_s).unwrap();
            sample.time_s += jitter * period_s * ((k * 37 % 7) as f64 / 3.5 - 1.0);
            sample.v_n = sample.v_n.filter(|_| with_velocity);
            sample
        };
        let (mut straight, mut paused) = (troubled(&options), troubled(&options));
        let mut shift_s = 0.0;
        for k in 0..600 {
            let sample = sample(k);
            straight.push_sample(&sample).unwrap();
            paused.push_sample(&FlightSample { time_s: sample.time_s + shift_s, ..sample }).unwrap();
            if [100, 200, 201, 300].contains(&k) {
                shift_s = [3600.0, 1_700_000_000.0, -5000.0, 0.0][k % 4];
                paused.move_time(sample.time_s + shift_s).unwrap();
                // A snapshot of this moment restores the same simulator.
                let mut loaded = Simulator::new(&Options::default()).unwrap();
                loaded.load_snapshot(&snapshot(&paused)).unwrap();
                assert_eq!((reads(&loaded), snapshot(&loaded)), (reads(&paused), snapshot(&paused)));
                paused = loaded;
            }
            // Three samples are in the queue.
            if k > 3 {
                assert_eq!((straight.step(), paused.step()), (Ok(Step::Done), Ok(Step::Done)));
                assert_eq!(without_times(&paused), without_times(&straight), "sample {k}");
            }
        }
        let accuracy = |simulator: &Simulator| simulator.accuracy().unwrap().unwrap().1;
        let (a, b) = (accuracy(&paused), accuracy(&straight));
        // Time moved to 1.7e9 s and back; a stamp there is rounded to 2.4e-7 s.
        assert!((a.duration_s - b.duration_s).abs() < 1e-6 && a.velocity_rms_n == b.velocity_rms_n);
        assert!(paused.truth().unwrap().unwrap().time_s.abs() < 1e4);
    }
}

/// A trainer pauses for an hour. A reposition loses the drift; a moved time keeps it to the bit.
#[test]
fn a_paused_trainer_keeps_its_drift() {
    let mut trainer = troubled(&Options::default());
    let samples: Vec<_> = (0..3000).map(|k| resting_sample(f64::from(k) * 0.02)).collect();
    fly_through(&mut trainer, &samples);
    let drift = errors(&trainer, ErrorSource::Navigation).position_n;
    let later = samples[2999].time_s + 3600.0;
    trainer.move_time(later).unwrap();
    assert_eq!(errors(&trainer, ErrorSource::Navigation).position_n, drift);
    assert_eq!(trainer.truth().unwrap().unwrap().time_s, later);
    assert_eq!(trainer.push_sample(&resting_sample(later + 0.02)), Ok(Pushed::Regular));
    trainer.reposition(&resting_sample(later + 0.02)).unwrap();
    assert_ne!(errors(&trainer, ErrorSource::Navigation).position_n, drift);
}

/// At both ends of the valid time, a snapshot restores stamps that are earlier or later than the stated period requires.
#[test]
fn a_flight_at_the_ends_of_time_is_saved_and_loaded() {
    let options = Options {
        intake: IntakeLimits { period_s: Some(0.01), ..IntakeLimits::default() },
        ..Options::default()
    };
    for end_s in [-9.99998e9, 9.99998e9] {
        for off_s in [-0.003, 0.003] {
            let mut simulator = Simulator::new(&options).unwrap();
            for time_s in [0.0, 0.01, 0.02 + off_s] {
                simulator.push_sample(&resting_sample(time_s)).unwrap();
            }
            simulator.move_time(end_s).unwrap();
            let saved = snapshot(&simulator);
            let mut loaded = Simulator::new(&options).unwrap();
            loaded.load_snapshot(&saved).unwrap();
            assert!(snapshot(&loaded) == saved, "{end_s} {off_s}");
        }
    }
}

/// A gap is reported when the sample after it is pushed. The library's rule compares the interval with the two intervals before it.
#[test]
fn a_gap_is_told_by_its_push() {
    let mut simulator = Simulator::new(&Options::default()).unwrap();
    // Intervals of 1, 0.02, 0.02, 0.04, 0.09, 0.11, 0.29, 0.71, 0.02, 1.75 and 0.02 s, then of 4.4 times 0.02 s, less than 1.75 s.
    let stamps = [0.0, 1.0, 1.02, 1.04, 1.08, 1.17, 1.28, 1.57, 2.28, 2.30, 4.05, 4.07, 4.158];
    let (mut before, mut last, mut gaps): ([f64; 2], f64, Vec<f64>) = ([0.0; 2], 0.0, Vec::new());
    for time_s in stamps {
        let interval: f64 = time_s - last;
        let usual = before[0].max(before[1]);
        let is_gap = usual > 0.0 && interval > 2.5 * usual;
        if simulator.push_sample(&resting_sample(time_s)).unwrap() == Pushed::BehindGap {
            gaps.push(time_s);
        }
        assert_eq!(gaps.last() == Some(&time_s), is_gap, "{time_s}");
        (before, last) = ([interval, before[0]], time_s);
    }
    assert_eq!(gaps, [1.57]);
    // The clock advances by one second at 100 Hz.
    let mut simulator = Simulator::new(&Options::default()).unwrap();
    fly_through(&mut simulator, (0..10).map(|k| resting_sample(f64::from(k) * 0.01)));
    assert_eq!(simulator.push_sample(&resting_sample(1.1)), Ok(Pushed::BehindGap));
}

/// A pause of 2 s that the library is not told of: the INS flies on, with a positive status alone. The truth does not move, so the error
/// is the path of 2 s, less the bend of the path.
#[test]
fn a_pause_that_is_not_told_moves_the_ins_by_its_speed() {
    let flight = patrol(100.0);
    let mut simulator = Simulator::new(&Options::default()).unwrap();
    let at = |k: u32| flight.sample_at(f64::from(k) * 0.01).unwrap();
    fly_through(&mut simulator, (0..6000).map(at));
    let speed = at(6000).v_n.unwrap().norm();
    let late = FlightSample { time_s: at(6000).time_s + 2.0, ..at(6000) };
    assert_eq!(simulator.push_sample(&late), Ok(Pushed::BehindGap));
    simulator.step().unwrap();
    let (_, errors) = simulator.errors(ErrorSource::Navigation).unwrap().unwrap();
    let moved = errors.position_n.xy().norm();
    println!("a pause of 2 s at {speed:.0} m/s moves the INS by {moved:.0} m");
    assert!((moved / (2.0 * speed) - 1.0).abs() < 0.01, "{moved} {speed}");
}

/// A first stamp of -0 with a stated period survives a snapshot.
#[test]
fn a_first_stamp_of_minus_zero_is_zero() {
    let options =
        Options { intake: IntakeLimits { period_s: Some(0.02), ..Default::default() }, ..Default::default() };
    let mut simulator = Simulator::new(&options).unwrap();
    simulator.push_sample(&resting_sample(-0.0)).unwrap();
    let mut loaded = Simulator::new(&Options::default()).unwrap();
    loaded.load_snapshot(&snapshot(&simulator)).unwrap();
    assert_eq!((reads(&loaded), snapshot(&loaded)), (reads(&simulator), snapshot(&simulator)));
    assert!(simulator.truth().unwrap().unwrap().time_s.is_sign_positive());
}
