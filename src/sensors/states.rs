//! What effects keep of many runs, side by side.

use super::draw::normal_each;
use super::stream::Stream;
use crate::error::Error;
use crate::memory::room;
use crate::signal::{RUNS, Row};

/// A stream of each run of a block: the words of its generator in rows.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
pub(super) struct StreamRows([[u64; RUNS]; 4]);

impl StreamRows {
    /// The next normal number of each of the first `count` runs.
    #[inline(always)]
    pub fn normal(&mut self, count: usize) -> Row {
        normal_each(&mut self.0, count)
    }
}

/// Numbers and streams of the runs of a block, in the order of the effects that keep them.
#[derive(Debug, Clone)]
pub(crate) struct StateRows {
    numbers: Box<[Row]>,
    streams: Box<[StreamRows]>,
}

/// Goes over what an effect keeps of one run.
pub(super) trait Visitor {
    fn number(&mut self, number: &mut f64);
    fn stream(&mut self, stream: &mut Stream);

    fn numbers<'a>(&mut self, numbers: impl IntoIterator<Item = &'a mut f64>) {
        numbers.into_iter().for_each(|number| self.number(number));
    }
}

/// Counts them.
#[derive(Default)]
pub(super) struct Count {
    numbers: usize,
    streams: usize,
}

impl Visitor for Count {
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
        let mut numbers = room(self.numbers)?;
        numbers.resize(self.numbers, [0.0; RUNS]);
        let mut streams = room(self.streams)?;
        streams.resize(self.streams, StreamRows([[0; RUNS]; 4]));
        Ok(StateRows { numbers: numbers.into_boxed_slice(), streams: streams.into_boxed_slice() })
    }
}

/// Lays them into a lane.
pub(super) struct Into<'a> {
    pub rows: &'a mut StateRows,
    pub lane: usize,
    pub next: Count,
}

impl Visitor for Into<'_> {
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

/// Takes them from a lane.
pub(super) struct From<'a> {
    pub rows: &'a StateRows,
    pub lane: usize,
    pub next: Count,
}

impl Visitor for From<'_> {
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

impl StateRows {
    /// All as in `other`, which has as many rows.
    pub fn copy_from(&mut self, other: &Self) {
        self.numbers.copy_from_slice(&other.numbers);
        self.streams.copy_from_slice(&other.streams);
    }

    /// The run at `lane` as in `other`.
    pub fn go_back(&mut self, lane: usize, other: &Self) {
        for (row, before) in self.numbers.iter_mut().zip(&other.numbers) {
            row[lane] = before[lane];
        }
        for (rows, before) in self.streams.iter_mut().zip(&other.streams) {
            rows.0.iter_mut().zip(&before.0).for_each(|(row, before)| row[lane] = before[lane]);
        }
    }

    /// Bytes of a run.
    pub fn bytes_of_run(&self) -> usize {
        (size_of_val(&*self.numbers) + size_of_val(&*self.streams)) / RUNS
    }

    /// To be taken by one effect after the other.
    #[inline(always)]
    pub(super) fn states(&mut self) -> States<'_> {
        States { numbers: &mut self.numbers, streams: &mut self.streams }
    }
}

/// What the effects to come keep.
pub(super) struct States<'a> {
    numbers: &'a mut [Row],
    streams: &'a mut [StreamRows],
}

impl<'a> States<'a> {
    /// The next rows of numbers.
    #[inline(always)]
    pub fn numbers<const N: usize>(&mut self) -> &'a mut [Row; N] {
        let Some((first, rest)) = core::mem::take(&mut self.numbers).split_first_chunk_mut() else {
            unreachable!("as many as were counted")
        };
        self.numbers = rest;
        first
    }

    /// The next streams.
    #[inline(always)]
    pub fn streams<const N: usize>(&mut self) -> &'a mut [StreamRows; N] {
        let Some((first, rest)) = core::mem::take(&mut self.streams).split_first_chunk_mut() else {
            unreachable!("as many as were counted")
        };
        self.streams = rest;
        first
    }
}
