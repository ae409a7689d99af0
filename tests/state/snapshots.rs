//! A run that is saved at any moment and loaded into any simulator continues to the same bits.

use sins::{Options, Simulator};

use crate::support::moments::{Call, reads, snapshot};
use crate::support::runs::{Run, everything_at_once, largest, runs};

/// The answer and all reads after each call.
fn play(simulator: &mut Simulator, calls: &[Call]) -> Vec<String> {
    calls.iter().map(|call| call.make(simulator) + &reads(simulator)).collect()
}

/// Each snapshot of each run is loaded into a new simulator with other options, and some into the simulator that has flown to
/// the end.
#[test]
fn the_rest_of_a_run_is_the_same_to_the_bit() {
    for Run { name, options, calls, every } in runs() {
        let mut straight = Simulator::new(&options).unwrap();
        let mut moments = vec![(0, snapshot(&straight), reads(&straight))];
        let mut expected = Vec::new();
        for (done, call) in calls.iter().enumerate() {
            expected.push(call.make(&mut straight) + &reads(&straight));
            if (done + 1) % every == 0 {
                moments.push((done + 1, snapshot(&straight), reads(&straight)));
            }
        }
        assert!(expected.iter().any(|heard| heard.starts_with("Ok(Done)")), "{name}");
        let end = snapshot(&straight);
        for (done, saved, heard) in moments {
            let mut fresh = Simulator::new(&Options::default()).unwrap();
            fresh.load_snapshot(&saved).unwrap_or_else(|error| panic!("{name}, after call {done}: {error}"));
            assert_eq!(reads(&fresh), heard, "{name}, after call {done}");
            assert!(snapshot(&fresh) == saved, "{name}, after call {done}: saved again");
            assert!(play(&mut fresh, &calls[done..]) == expected[done..], "{name}, fresh, after call {done}");
            assert!(snapshot(&fresh) == end, "{name}, after call {done}: saved at the end");
            if done % 7 == 0 {
                straight.load_snapshot(&saved).unwrap();
                assert!(
                    play(&mut straight, &calls[done..]) == expected[done..],
                    "{name}, the same, after call {done}"
                );
            }
        }
    }
}

/// A reset after a load restarts the saved run.
#[test]
fn a_reset_after_a_load_is_the_start_of_that_run() {
    let Run { options, calls, .. } = largest();
    let mut straight = Simulator::new(&options).unwrap();
    let expected = play(&mut straight, &calls);
    let mut loaded = Simulator::new(&Options::default()).unwrap();
    loaded.load_snapshot(&snapshot(&straight)).unwrap();
    loaded.reset();
    assert_eq!(play(&mut loaded, &calls), expected);
}

/// Bytes of a run's snapshot with its last `waiting` samples in the queue.
fn size_of(run: &Run, waiting: usize) -> usize {
    let mut simulator = Simulator::new(&run.options).unwrap();
    let flown = run.calls.len() - 2 * waiting;
    play(&mut simulator, &run.calls[..flown]);
    let pushes = run.calls[flown..].iter().filter(|call| matches!(call, Call::Push(_)));
    pushes.for_each(|call| assert!(call.make(&mut simulator).starts_with("Ok")));
    assert_eq!(simulator.waiting_samples(), waiting);
    simulator.snapshot_size()
}

/// The buffer holds every setting at once, with an empty and with a full queue.
#[test]
fn the_buffer_of_the_interface_holds_everything_at_once() {
    let run = everything_at_once();
    let mut simulator = Simulator::new(&run.options).unwrap();
    assert!(run.calls.iter().all(|call| call.make(&mut simulator).starts_with("Ok")));
    for waiting in [0, 16] {
        let size = size_of(&run, waiting);
        println!("everything at once, {waiting} samples wait: {size} bytes");
        assert!(size <= sins::abi::SINS_SNAPSHOT_MAX_SIZE, "{size}");
    }
}

/// Upper bound of the bytes of a covariance: its columns, and a hundred numbers of the motion.
const COVARIANCE: usize = ((76 + 11) * 11 + 100) * 9;

/// 4.5 KiB hold a run with every parameter of gyros, accelerometers and altimeter and a truth summary, if no sample is in the
/// queue. Samples in the queue need more. So do mounting, gravity, temperature and failures together, and a covariance: eleven
/// errors, with at most 76 processes and with each other.
#[test]
fn a_snapshot_is_small() {
    for run in runs() {
        let size = size_of(&run, 0);
        println!("{}: {size} bytes", run.name);
        let covariance = if run.options.covariance { COVARIANCE } else { 0 };
        assert!(size <= 4608 + covariance, "{}: {size}", run.name);
    }
    let largest = largest();
    for waiting in [4, 16] {
        let size = size_of(&largest, waiting);
        println!("largest, {waiting} samples wait: {size} bytes");
        // Each sample has seventeen numbers and the sizes of their words.
        assert!(size <= 4608 + COVARIANCE + waiting * 17 * 9 && size <= sins::abi::SINS_SNAPSHOT_MAX_SIZE);
    }
}
