//! Snapshots of any moment, also altered and forged, and a simulator that continues from a snapshot in parallel with the
//! saved one.

use std::ptr::null_mut;

use sins::abi::*;

use crate::call;
use crate::host::{Host, Sim, look_at_all};
use crate::trace;
use crate::words::{snapshot_of, words_of};

/// The snapshot of a simulator; empty without a simulator.
pub fn frozen(sim: *mut sins_sim) -> Vec<u8> {
    let mut bytes = vec![0; SINS_SNAPSHOT_MAX_SIZE];
    let mut written = 0;
    call!(sins_snapshot_save(sim, bytes.as_mut_ptr().cast(), bytes.len(), &mut written));
    bytes.truncate(written);
    bytes
}

fn load(sim: *mut sins_sim, snapshot: &[u8]) -> sins_status {
    call!(sins_snapshot_load(sim, snapshot.as_ptr().cast(), snapshot.len()))
}

/// A simulator that was loaded from the snapshot of another, the leader, and gets the same calls. Its answers and its state
/// must equal the leader's.
pub struct Follower {
    pub handle: *mut sins_sim,
    leader: Option<usize>,
    /// Number of calls until both are compared.
    pub calls_left: usize,
}

impl Default for Follower {
    fn default() -> Self {
        Self { handle: null_mut(), leader: None, calls_left: 0 }
    }
}

impl Follower {
    /// Asserts that a snapshot of `sim` loads and gives the same simulator.
    pub fn compare(&mut self, sim: *mut sins_sim) {
        if self.handle.is_null() {
            // SAFETY: no options, and room for a handle.
            assert_eq!(unsafe { sins_create(std::ptr::null(), &mut self.handle) }, SINS_OK, "no simulator");
        }
        let saved = frozen(sim);
        if saved.is_empty() {
            return;
        }
        let mut size = 0;
        assert_eq!(call!(sins_snapshot_size(sim, &mut size)), SINS_OK);
        assert_eq!(size, saved.len());
        let status = load(self.handle, &saved);
        assert!(status == SINS_OK, "an unaltered snapshot was refused: {}", sentence(self.handle));
        assert!(frozen(self.handle) == saved, "another simulator than the saved one");
    }

    fn begin(&mut self, place: usize, sim: *mut sins_sim, calls: usize) {
        if sim.is_null() {
            return;
        }
        self.compare(sim);
        (self.leader, self.calls_left) = (Some(place), calls);
    }

    /// Makes the leader's call on the follower too.
    pub fn follow(&mut self, place: usize, status: sins_status, call: impl Fn(*mut sins_sim) -> sins_status) {
        if self.leader == Some(place) {
            assert!(call(self.handle) == status, "another answer from the simulator that was loaded");
            self.calls_left = self.calls_left.saturating_sub(1);
        }
    }

    /// Ends the following of the simulator at `place`, whose handle is `sim`, and compares both.
    pub fn part(&mut self, place: usize, sim: *mut sins_sim) {
        if self.leader == Some(place) {
            self.leader = None;
            assert!(frozen(sim) == frozen(self.handle), "the simulator that was loaded went on otherwise");
        }
    }
}

/// The words of the last failed call, without its numbers.
pub fn sentence(sim: *mut sins_sim) -> String {
    let mut text = [0_u8; 256];
    // SAFETY: the buffer has the stated size.
    unsafe { sins_last_error(sim, text.as_mut_ptr().cast(), text.len(), null_mut()) };
    let text =
        String::from_utf8_lossy(&text[..text.iter().position(|&byte| byte == 0).unwrap_or(0)]).into_owned();
    match text.split_once(" = ") {
        Some((field, rest)) => format!("{field} [{rest}]"),
        None => text,
    }
}

impl Host {
    /// Ends the following when no calls are left.
    pub fn watch_follower(&mut self) {
        if let Some(place) = self.follower.leader
            && self.follower.calls_left == 0
        {
            self.follower.part(place, self.sims[place].handle);
        }
    }

    /// Starts to follow a simulator.
    pub fn follow(&mut self) {
        let place = self.place();
        let (sim, calls) = (self.sims[place].handle, self.input.below(32));
        if let Some(leader) = self.follower.leader {
            self.follower.part(leader, self.sims[leader].handle);
        }
        self.follower.begin(place, sim, calls);
    }

    /// The simulator `to` was loaded from `from`, so it also gets its motion.
    fn become_like(&mut self, from: usize, to: usize) {
        let Sim { motion, aboard, is_navigating, is_mounted, .. } = self.sims[from];
        self.sims[to] = Sim { handle: self.sims[to].handle, motion, aboard, is_navigating, is_mounted };
    }

    /// Loads the snapshot of a simulator into another one or into itself.
    pub fn thaw(&mut self) {
        let (from, to) = (self.place(), self.place());
        let saved = frozen(self.sims[from].handle);
        if saved.is_empty() || self.sims[to].handle.is_null() {
            return;
        }
        self.follower.part(to, self.sims[to].handle);
        let status = load(self.sims[to].handle, &saved);
        assert!(status == SINS_OK, "an unaltered snapshot was refused: {}", sentence(self.sims[to].handle));
        assert!(frozen(self.sims[to].handle) == saved, "another simulator than the saved one");
        self.become_like(from, to);
    }

    /// A snapshot that was altered or truncated is rejected.
    pub fn tamper(&mut self) {
        let (from, to) = (self.place(), self.place());
        let mut snapshot = frozen(self.sims[from].handle);
        if snapshot.is_empty() {
            return;
        }
        let at = self.input.word() as usize % snapshot.len();
        match self.input.below(4) {
            0 => snapshot.truncate(at),
            1 => snapshot[at] = !snapshot[at],
            _ => snapshot[at] ^= 1 << self.input.below(8),
        }
        self.changing(to, true, |sim| {
            let status = load(sim, &snapshot);
            assert!(status < 0, "an altered snapshot was taken");
            status
        });
    }

    /// A snapshot with altered words and a valid checksum is rejected, or it makes a simulator that works.
    pub fn forge(&mut self) {
        let (from, to) = (self.place(), self.place());
        let snapshot = frozen(self.sims[from].handle);
        if snapshot.is_empty() {
            return;
        }
        let mut words = words_of(&snapshot);
        assert!(snapshot_of(&words) == snapshot, "the words of a snapshot");
        for _ in 0..1 + self.input.below(3) {
            let at = self.input.word() as usize % words.len();
            let value = f64::from_bits(words[at]);
            let old = words[at];
            words[at] = match self.input.byte() {
                0..32 => self.input.number().to_bits(),
                32..64 => self.input.within((-1e12, 1e12)).to_bits(),
                64..96 => (value * self.input.pick(&[-1.0, 2.0, 1e3, 1e-3, 1e10, 1.0 + 1e-9])).to_bits(),
                96..128 => words[at] ^ 1 << self.input.below(64),
                128..160 => words[self.input.word() as usize % words.len()],
                // Flags and counts.
                160..224 if words[at] <= 0xff => u64::from(self.input.byte() % 20),
                _ => self.input.word(),
            };
            let new = words[at];
            trace::note(|| format!("word {at} {old:#x} ({value}) to {new:#x} ({})", f64::from_bits(new)));
        }
        let snapshot = snapshot_of(&words);
        self.follower.part(to, self.sims[to].handle);
        let status = self.changing(to, true, |sim| load(sim, &snapshot));
        if status == SINS_OK {
            trace::forge();
            self.become_like(from, to);
            self.sims[to].is_mounted = true;
            look_at_all(self.sims[to].handle);
        }
    }
}
