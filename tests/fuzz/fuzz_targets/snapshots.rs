//! Snapshots of any words after a valid header and checksum: each is rejected, or it makes a simulator that works and
//! can be saved and loaded again.

#![no_main]

use libfuzzer_sys::{fuzz_mutator, fuzz_target, fuzzer_mutate};
use sins::{Options, Simulator};
use sins_fuzz::Random;
use sins_fuzz::words::{snapshot_of, words_of};

/// Everything that can be read, as text that shows every bit of a finite number.
fn reads(simulator: &Simulator) -> String {
    let text =
        format!("{:?}", (simulator.truth(), simulator.navigation(), simulator.imu(), simulator.accuracy()));
    assert!(!text.contains("NaN") && !text.contains("inf"), "infinite or no number");
    text
}

fn thawed(snapshot: &[u8]) -> Option<Simulator> {
    let mut simulator = Simulator::new(&Options::default()).ok()?;
    simulator.load_snapshot(snapshot).ok().map(|()| simulator)
}

fuzz_target!(|bytes: &[u8]| {
    let mut forged = bytes.to_vec();
    sins::snapshot::seal(&mut forged, sins::snapshot::SnapshotOf::Simulator);
    let Some(mut simulator) = thawed(&forged) else { return };
    let mut again = vec![0; simulator.snapshot_size()];
    simulator.save_snapshot(&mut again).expect("room for it");
    let mut twin = thawed(&again).expect("what was accepted is accepted again");
    for _ in 0..20 {
        assert_eq!(format!("{:?}", simulator.step()), format!("{:?}", twin.step()));
        assert_eq!(reads(&simulator), reads(&twin));
    }
});

// A word is altered or copied from another place. The other words keep their values, even if the size of this word changes.
fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    let mut random = Random(u64::from(seed));
    let mut words = words_of(&data[..size]);
    if words.is_empty() || random.word().is_multiple_of(8) {
        return fuzzer_mutate(data, size, max_size);
    }
    let (at, from) = (random.word() as usize % words.len(), random.word() as usize % words.len());
    let mut bytes = words[at].to_le_bytes();
    words[at] = match random.word() % 4 {
        0 => words[from],
        _ => {
            fuzzer_mutate(&mut bytes, 8, 8);
            u64::from_le_bytes(bytes)
        }
    };
    let snapshot = snapshot_of(&words);
    let length = snapshot.len().min(max_size);
    data[..length].copy_from_slice(&snapshot[..length]);
    length
});
