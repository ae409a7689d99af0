//! States of the effects of many runs, side by side.

use core::mem::take;

use super::super::draw::normal_each;
use super::super::stream::Stream;
use super::Name;
use crate::base::error::Error;
use crate::base::memory::filled;
use crate::signal::{RUNS, Row};

/// One stream for each run of a batch. The words of the generators are in rows.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
pub(in crate::sensors) struct StreamRows([[u64; RUNS]; 4]);

impl StreamRows {
    /// The next normal number of each run.
    #[inline(always)]
    pub fn normal(&mut self) -> Row {
        normal_each(&mut self.0)
    }
}

/// Constants, numbers and streams of the runs of a batch, in the order of the effects that keep them.
#[derive(Debug, Clone)]
pub(crate) struct StateRows {
    /// Numbers drawn at turn-on, which no interval changes.
    constants: Box<[Row]>,
    numbers: Box<[Row]>,
    streams: Box<[StreamRows]>,
}

/// Visits each part of the state of an effect of one run.
pub(in crate::sensors) trait Visitor {
    fn constant(&mut self, number: &mut f64);
    fn number(&mut self, number: &mut f64);
    fn stream(&mut self, stream: &mut Stream);

    fn constants<'a>(&mut self, numbers: impl IntoIterator<Item = &'a mut f64>) {
        numbers.into_iter().for_each(|number| self.constant(number));
    }

    fn numbers<'a>(&mut self, numbers: impl IntoIterator<Item = &'a mut f64>) {
        numbers.into_iter().for_each(|number| self.number(number));
    }
}

/// Counts constants, numbers and streams.
#[derive(Default)]
pub(in crate::sensors) struct Count {
    constants: usize,
    numbers: usize,
    streams: usize,
}

impl Visitor for Count {
    fn constant(&mut self, _: &mut f64) {
        self.constants += 1;
    }

    fn number(&mut self, _: &mut f64) {
        self.numbers += 1;
    }

    fn stream(&mut self, _: &mut Stream) {
        self.streams += 1;
    }
}

impl Count {
    /// Rows for all that was counted.
    pub fn rows(&self) -> Result<StateRows, Error> {
        Ok(StateRows {
            constants: filled(self.constants, [0.0; RUNS])?,
            numbers: filled(self.numbers, [0.0; RUNS])?,
            streams: filled(self.streams, StreamRows([[0; RUNS]; 4]))?,
        })
    }
}

/// Copies constants, numbers and streams into a lane.
pub(in crate::sensors) struct PutLane<'a> {
    pub rows: &'a mut StateRows,
    pub lane: usize,
    pub next: Count,
}

impl Visitor for PutLane<'_> {
    fn constant(&mut self, number: &mut f64) {
        self.rows.constants[self.next.constants][self.lane] = *number;
        self.next.constant(number);
    }

    fn number(&mut self, number: &mut f64) {
        self.rows.numbers[self.next.numbers][self.lane] = *number;
        self.next.number(number);
    }

    fn stream(&mut self, stream: &mut Stream) {
        let rows = &mut self.rows.streams[self.next.streams].0;
        rows.iter_mut().zip(stream.words()).for_each(|(row, word)| row[self.lane] = word);
        self.next.stream(stream);
    }
}

/// Copies constants, numbers and streams from a lane.
pub(in crate::sensors) struct TakeLane<'a> {
    pub rows: &'a StateRows,
    pub lane: usize,
    pub next: Count,
}

impl Visitor for TakeLane<'_> {
    fn constant(&mut self, number: &mut f64) {
        *number = self.rows.constants[self.next.constants][self.lane];
        self.next.constant(number);
    }

    fn number(&mut self, number: &mut f64) {
        *number = self.rows.numbers[self.next.numbers][self.lane];
        self.next.number(number);
    }

    fn stream(&mut self, stream: &mut Stream) {
        let rows = &self.rows.streams[self.next.streams].0;
        *stream = Stream::of_words([0, 1, 2, 3].map(|i: usize| rows[i][self.lane]));
        self.next.stream(stream);
    }
}

/// Exchanges streams with streams set aside: the first visit sets the streams of the effects aside and gives the effects others, the
/// second visit, from `next` = 0 on, brings the first ones back.
pub(in crate::sensors) struct Aside {
    streams: [Option<Stream>; 3 * Name::ALL.len()],
    pub next: usize,
}

impl Aside {
    pub const NOTHING: Self = Self { streams: [const { None }; 3 * Name::ALL.len()], next: 0 };
}

impl Visitor for Aside {
    fn constant(&mut self, _: &mut f64) {}

    fn number(&mut self, _: &mut f64) {}

    fn stream(&mut self, stream: &mut Stream) {
        let Some(aside) = self.streams.get_mut(self.next) else { unreachable!("at most one stream an axis") };
        self.next += 1;
        let other = aside.take().unwrap_or_else(|| stream.other());
        *aside = Some(core::mem::replace(stream, other));
    }
}

impl StateRows {
    /// Sets the run at `lane` back to `other`, the `before` of [`Self::states`].
    pub fn go_back(&mut self, lane: usize, other: &Self) {
        for (row, before) in self.numbers.iter_mut().zip(&other.numbers) {
            row[lane] = before[lane];
        }
        for (rows, before) in self.streams.iter_mut().zip(&other.streams) {
            rows.0.iter_mut().zip(&before.0).for_each(|(row, before)| row[lane] = before[lane]);
        }
    }

    /// Memory of one run [bytes].
    pub fn bytes_of_run(&self) -> usize {
        (size_of_val(&*self.constants) + size_of_val(&*self.numbers) + size_of_val(&*self.streams)) / RUNS
    }

    /// The rows, which the effects take one after the other. `before` has the same number of rows, and gets a copy of each row that
    /// is taken.
    #[inline(always)]
    pub(in crate::sensors) fn states<'a>(&'a mut self, before: &'a mut Self) -> States<'a> {
        States {
            constants: &self.constants,
            numbers: (&mut self.numbers, &mut before.numbers),
            streams: (&mut self.streams, &mut before.streams),
        }
    }
}

/// The rows that are not taken yet, and room for their copies.
pub(in crate::sensors) struct States<'a> {
    constants: &'a [Row],
    numbers: (&'a mut [Row], &'a mut [Row]),
    streams: (&'a mut [StreamRows], &'a mut [StreamRows]),
}

impl<'a> States<'a> {
    /// The next rows of constants.
    #[inline(always)]
    pub fn constants<const N: usize>(&mut self) -> &'a [Row; N] {
        let Some((first, rest)) = self.constants.split_first_chunk() else {
            unreachable!("as many as were counted")
        };
        self.constants = rest;
        first
    }

    /// The next rows of numbers.
    #[inline(always)]
    pub fn numbers<const N: usize>(&mut self) -> &'a mut [Row; N] {
        next(&mut self.numbers)
    }

    /// The next streams.
    #[inline(always)]
    pub fn streams<const N: usize>(&mut self) -> &'a mut [StreamRows; N] {
        next(&mut self.streams)
    }
}

/// The next rows of the first slice. The second slice gets a copy of them.
#[inline(always)]
fn next<'a, T: Copy, const N: usize>((now, before): &mut (&'a mut [T], &'a mut [T])) -> &'a mut [T; N] {
    let (Some((first, rest)), Some((kept, others))) =
        (take(now).split_first_chunk_mut(), take(before).split_first_chunk_mut())
    else {
        unreachable!("as many as were counted")
    };
    *kept = *first;
    (*now, *before) = (rest, others);
    first
}
