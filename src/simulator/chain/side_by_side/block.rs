//! Some runs side by side.

use core::ops::Range;

use crate::earth::Earth;
use crate::error::Error;
use crate::instruction_set::{InstructionSet, Work};
use crate::mechanization::{AidOfEach, Mechanization, NavigatorBlock, Scheme, Scratch, VerticalAid};
use crate::memory::room;
use crate::sensors::{Altimeter, SharedInput, StateRows};
use crate::signal::{Increment, IncrementRows, MAX_INCREMENTS, RUNS, Row, increment_of};
use crate::simulator::chain::Chain;
use crate::simulator::{ImuFlags, ImuInterval, Options, SensorSuite};

/// What an interval brings to all blocks.
pub(super) struct Interval<'a> {
    pub earth: &'a Earth,
    pub options: &'a Options,
    pub sensors: &'a SensorSuite,
    pub shared: &'a [SharedInput; 2],
    /// Time of its start [s].
    pub start_s: f64,
    /// Length [s], and that of its increments.
    pub t: f64,
    pub dt: f64,
    /// Number of increments.
    pub count: usize,
    /// Of an altimeter with errors the true height.
    pub aid: VerticalAid,
}

/// Numbers in the longest vector of any instruction set.
const LANES: usize = 8;

/// Up to [`RUNS`] runs.
#[derive(Debug)]
pub(super) struct Block {
    count: usize,
    /// Lanes that are computed: whole vectors. Those beyond the runs are copies of the last one.
    lanes: usize,
    gyro: StateRows,
    accel: StateRows,
    navigators: NavigatorBlock,
    /// Sum of the measured increments of the last interval.
    measured: IncrementRows,
    /// Whether gyros and accelerometers were beyond their range in it.
    saturated: [[bool; RUNS]; 2],
    north_unknown: [bool; RUNS],
    /// Time of the last good solution of a run that has diverged [s].
    diverged_s: [Option<f64>; RUNS],
    /// Where they have errors.
    altimeters: Box<[Altimeter]>,
}

/// What a step needs beside a block, and the block as it was before.
#[derive(Debug)]
pub(super) struct Workspace {
    /// Of the longest interval. By itself, or the compiler fears that it lies over the rest.
    measured: Box<[IncrementRows]>,
    scratch: Scratch,
    heights_m: Row,
    saturated: [[u64; RUNS]; 2],
    is_good: [u64; RUNS],
    gyro: StateRows,
    accel: StateRows,
    navigators: NavigatorBlock,
}

impl Workspace {
    /// For blocks with the sensors of `sensors`. On the heap, as it is much of a stack.
    pub fn new(sensors: &mut SensorSuite) -> Result<Box<[Self]>, Error> {
        let (gyro, accel) = (sensors.gyro.rows()?, sensors.accel.rows()?);
        let (mut memory, mut measured) = (room(1)?, room(MAX_INCREMENTS)?);
        measured.resize(MAX_INCREMENTS, [[0.0; RUNS]; 6]);
        memory.push(Self {
            measured: measured.into_boxed_slice(),
            scratch: Scratch::NONE,
            heights_m: [0.0; RUNS],
            saturated: [[0; RUNS]; 2],
            is_good: [0; RUNS],
            gyro,
            accel,
            navigators: NavigatorBlock::new(),
        });
        Ok(memory.into_boxed_slice())
    }
}

impl Block {
    /// Room for `count` runs.
    pub fn new(sensors: &mut SensorSuite, count: usize) -> Result<Self, Error> {
        let mut altimeters = Vec::new();
        if !sensors.altimeter.is_ideal() {
            altimeters = room(count)?;
            altimeters.resize(count, sensors.altimeter.clone());
        }
        Ok(Self {
            count,
            lanes: count.next_multiple_of(LANES).min(RUNS),
            gyro: sensors.gyro.rows()?,
            accel: sensors.accel.rows()?,
            navigators: NavigatorBlock::new(),
            measured: [[0.0; RUNS]; 6],
            saturated: [[false; RUNS]; 2],
            north_unknown: [false; RUNS],
            diverged_s: [None; RUNS],
            altimeters: altimeters.into_boxed_slice(),
        })
    }

    pub fn count(&self) -> usize {
        self.count
    }

    pub fn bytes_of_run(&self) -> usize {
        size_of::<Self>() / RUNS
            + self.gyro.bytes_of_run()
            + self.accel.bytes_of_run()
            + size_of_val(&*self.altimeters) / self.count
    }

    /// Lays the sensors of a run in.
    pub fn put_sensors(&mut self, lane: usize, sensors: &mut SensorSuite) {
        for lane in self.copies_of(lane) {
            sensors.gyro.put_into(&mut self.gyro, lane);
            sensors.accel.put_into(&mut self.accel, lane);
        }
        if let Some(altimeter) = self.altimeters.get_mut(lane) {
            altimeter.clone_from(&sensors.altimeter);
        }
    }

    /// Takes what a run keeps out, over `sensors` of the same parameters and key.
    pub fn take_sensors(&self, lane: usize, sensors: &mut SensorSuite) {
        sensors.gyro.take_from(&self.gyro, lane);
        sensors.accel.take_from(&self.accel, lane);
        if let Some(altimeter) = self.altimeters.get(lane) {
            sensors.altimeter.clone_from(altimeter);
        }
    }

    /// A run starts so, or cannot.
    pub fn start(&mut self, lane: usize, height_m: f64, start: Option<(&Mechanization, bool)>, time_s: f64) {
        if let Some(altimeter) = self.altimeters.get_mut(lane) {
            altimeter.reposition(height_m);
        }
        match start {
            Some((navigator, north_unknown)) => {
                self.put_navigator(lane, navigator);
                self.north_unknown[lane] = north_unknown;
            }
            None => self.diverged_s[lane] = Some(time_s),
        }
    }

    /// Time of the last good solution of a run that has diverged [s].
    pub fn diverged_s(&self, lane: usize) -> Option<f64> {
        self.diverged_s[lane]
    }

    /// All are good again.
    pub fn revive(&mut self) {
        self.diverged_s = [None; RUNS];
    }

    pub fn navigator(&self, lane: usize, earth: &Earth, scheme: Scheme) -> Mechanization {
        self.navigators.get(lane, earth, scheme)
    }

    /// The navigator of a run is another from now on.
    pub fn put_navigator(&mut self, lane: usize, navigator: &Mechanization) {
        self.copies_of(lane).for_each(|lane| self.navigators.put(lane, navigator));
    }

    /// The lanes with the run at `lane`.
    fn copies_of(&self, lane: usize) -> Range<usize> {
        if lane + 1 == self.count { lane..self.lanes } else { lane..lane + 1 }
    }

    /// Takes a run in that has flown as `chain` so far.
    pub fn put_run(&mut self, lane: usize, chain: &Chain) {
        self.put_navigator(lane, &chain.mechanization);
        self.north_unknown[lane] = chain.north_unknown;
        if let Some(ImuInterval { measured: Increment { angle, velocity }, flags, .. }) = chain.imu() {
            for axis in 0..3 {
                self.measured[axis][lane] = angle[axis];
                self.measured[3 + axis][lane] = velocity[axis];
            }
            self.saturated[0][lane] = flags.gyro_saturated;
            self.saturated[1][lane] = flags.accel_saturated;
        }
    }

    /// A run has diverged; its last good solution was at `time_s` [s].
    pub fn put_diverged(&mut self, lane: usize, time_s: f64) {
        self.diverged_s[lane] = Some(time_s);
    }

    pub fn north_unknown(&self, lane: usize) -> bool {
        self.north_unknown[lane]
    }

    /// What the sensors gave in the last interval, and their flags.
    pub fn measured(&self, lane: usize) -> (Increment, ImuFlags) {
        let [gyro_saturated, accel_saturated] = self.saturated.map(|row| row[lane]);
        let flags = ImuFlags { gyro_saturated, accel_saturated, ..ImuFlags::default() };
        (increment_of(&self.measured, lane), flags)
    }

    /// Flies an interval.
    pub fn fly(&mut self, set: InstructionSet, interval: &Interval<'_>, workspace: &mut Workspace) {
        workspace.gyro.copy_from(&self.gyro);
        workspace.accel.copy_from(&self.accel);
        workspace.navigators.clone_from(&self.navigators);
        if let (VerticalAid::Barometer { height_m }, false) = (interval.aid, self.altimeters.is_empty()) {
            let lanes = self.altimeters.iter_mut().zip(&mut workspace.heights_m).zip(&self.diverged_s);
            for ((altimeter, indicated_m), _) in lanes.filter(|(_, diverged_s)| diverged_s.is_none()) {
                *indicated_m = altimeter.sense(height_m, interval.t).unwrap_or(height_m);
            }
        } else if let VerticalAid::Barometer { height_m } = interval.aid {
            workspace.heights_m = [height_m; RUNS];
        }
        let before = (self.measured, self.saturated);
        set.for_tables().run(Sensing { block: self, interval, workspace });
        set.run(Navigating { block: self, interval, workspace });
        for lane in 0..self.count {
            if self.diverged_s[lane].is_some() || workspace.is_good[lane] == 0 {
                self.look_closely(lane, interval, workspace, &before);
            }
        }
    }

    /// At the run at `lane`: it is still good, or it goes back and stays there.
    #[cold]
    #[inline(never)]
    fn look_closely(
        &mut self,
        lane: usize,
        interval: &Interval<'_>,
        workspace: &Workspace,
        (measured, saturated): &(IncrementRows, [[bool; RUNS]; 2]),
    ) {
        if self.diverged_s[lane].is_none() {
            let options = interval.options;
            if self.navigators.get(lane, interval.earth, options.scheme).check().is_ok() {
                return;
            }
            self.diverged_s[lane] = Some(interval.start_s);
            if let (Some(altimeter), VerticalAid::Barometer { .. }) =
                (self.altimeters.get_mut(lane), interval.aid)
            {
                altimeter.undo();
            }
        }
        self.navigators.go_back(lane, &workspace.navigators);
        self.gyro.go_back(lane, &workspace.gyro);
        self.accel.go_back(lane, &workspace.accel);
        self.measured.iter_mut().zip(measured).for_each(|(row, before)| row[lane] = before[lane]);
        self.saturated.iter_mut().zip(saturated).for_each(|(row, before)| row[lane] = before[lane]);
    }
}

/// The sensors of a block in an interval.
struct Sensing<'a> {
    block: &'a mut Block,
    interval: &'a Interval<'a>,
    workspace: &'a mut Workspace,
}

impl Work for Sensing<'_> {
    #[inline(always)]
    fn run(self) {
        let Self { block, interval, workspace } = self;
        let Block { lanes, gyro, accel, measured: sums, saturated, .. } = block;
        let Workspace { measured, saturated: marks, .. } = workspace;
        let &Interval { sensors, shared, dt, count, .. } = interval;
        let (lanes, measured) = (*lanes, &mut measured[..count]);

        *marks = [[0; RUNS]; 2];
        sensors.gyro.sense_block(&shared[0], dt, gyro, measured, &mut marks[0], lanes);
        sensors.accel.sense_block(&shared[1], dt, accel, measured, &mut marks[1], lanes);
        for (row, marks) in saturated.iter_mut().zip(marks) {
            for lane in 0..RUNS {
                row[lane] = marks[lane] != 0;
            }
        }
        for (i, sum) in sums.iter_mut().enumerate() {
            *sum = [0.0; RUNS];
            for rows in measured.iter() {
                for lane in 0..RUNS {
                    sum[lane] += rows[i][lane];
                }
            }
        }
    }
}

/// Its navigators.
struct Navigating<'a> {
    block: &'a mut Block,
    interval: &'a Interval<'a>,
    workspace: &'a mut Workspace,
}

impl Work for Navigating<'_> {
    #[inline(always)]
    fn run(self) {
        let Self { block, interval, workspace } = self;
        let Workspace { measured, scratch, heights_m, is_good, .. } = workspace;
        let &Interval { earth, options, t, count, aid, .. } = interval;
        let (lanes, navigators, measured) = (block.lanes, &mut block.navigators, &measured[..count]);
        let aid = match aid {
            VerticalAid::None => AidOfEach::None,
            VerticalAid::Truth { height_m, velocity_up_m_s } => {
                AidOfEach::Truth { height_m, velocity_up_m_s }
            }
            VerticalAid::Barometer { .. } => AidOfEach::Barometer { heights_m },
        };
        navigators.navigate((earth, options.scheme), options.subsamples, measured, t, lanes, scratch);
        navigators.aid_vertical(earth, &aid, t, lanes, is_good);
    }
}
