//! Snapshots of any words behind a good header and checksum: refused, or a simulator that works and freezes to itself.

#![no_main]

use libfuzzer_sys::fuzz_target;
use sins::{Options, Simulator};

/// All that can be read, as text, which has every bit of a finite number.
fn reads(simulator: &Simulator) -> String {
    format!("{:?}", (simulator.truth(), simulator.navigation(), simulator.imu(), simulator.accuracy()))
}

fn thawed(snapshot: &[u8]) -> Option<Simulator> {
    let mut simulator = Simulator::new(&Options::default()).ok()?;
    simulator.load_snapshot(snapshot).ok().map(|()| simulator)
}

fuzz_target!(|bytes: &[u8]| {
    let mut forged = bytes.to_vec();
    sins::snapshot::seal(&mut forged);
    let Some(mut simulator) = thawed(&forged) else { return };
    let mut again = vec![0; simulator.snapshot_size()];
    simulator.save_snapshot(&mut again).expect("room for it");
    let mut twin = thawed(&again).expect("what was accepted is accepted again");
    for _ in 0..20 {
        assert_eq!(format!("{:?}", simulator.step()), format!("{:?}", twin.step()));
        assert_eq!(reads(&simulator), reads(&twin));
    }
});
