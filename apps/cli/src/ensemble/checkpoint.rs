//! The checkpoint: one file with the results so far, from which the same order continues.
//!
//! The file has lines of text that describe the order, an empty line, the results as little-endian numbers, and a checksum of the
//! whole content. It is replaced as a whole. It is accepted if every line agrees with the current order and the checksum is right.

use std::fmt::Write;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use sins::ensemble::statistics::Statistics;
use sins::math::mix;
use sins::scene::{Output, Scene};

use super::plan::{BLOCK, Plan};
use super::results::{Results, State};
use crate::failure::Failure;
use crate::given::Given;
use crate::output::Outputs;
use crate::terminal::say;

/// First line of the file. Its number is the version of the layout.
const MARK: &str = "sins ensemble checkpoint 1";

/// Shortest time between two writes of the file, and as a multiple of the duration of a write. The first write is after the first
/// piece of work.
const RENEWED: Duration = Duration::from_secs(10);
const WRITING: u32 = 20;

/// A checkpoint: its path, its head, and the rules for its output.
pub struct Checkpoint {
    path: PathBuf,
    head: String,
    inputs: Vec<PathBuf>,
    force: bool,
    /// Time of the next write.
    next: Instant,
    /// Whether the disk has refused it.
    is_refused: bool,
}

impl Checkpoint {
    pub fn new(path: PathBuf, given: &Given, plan: &Plan, force: bool) -> Result<Self, Failure> {
        let head = head(given, plan)?;
        let (inputs, next) = (given.inputs.clone(), Instant::now());
        Ok(Self { path, head, inputs, force, next, is_refused: false })
    }

    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The results so far, if the file exists. Checks that the file can be written.
    pub fn read(&self, plan: &Plan) -> Result<Results, Failure> {
        // The rules of outputs: a file that is an input, or that this program did not write, is rejected.
        drop(Outputs::new(&self.inputs, self.force).file(&self.path, MARK)?);
        let bytes = match std::fs::read(&self.path) {
            Ok(bytes) if bytes.starts_with(MARK.as_bytes()) => bytes,
            // A file that this program did not write, which --force replaces.
            Ok(_) => return Ok(Results::new(plan)),
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Results::new(plan)),
            Err(error) => return Err(Failure::of_input(&self.path, &error)),
        };
        self.parse(&bytes, plan).map_err(|why| {
            Failure::of_file(
                &self.path,
                &format!("{why}; choose another --name, or remove the file to start again"),
            )
        })
    }

    fn parse(&self, bytes: &[u8], plan: &Plan) -> Result<Results, String> {
        let damaged = || "the checkpoint is damaged".to_owned();
        let (content, sum) = bytes.split_last_chunk().ok_or_else(damaged)?;
        if checksum(content) != u64::from_le_bytes(*sum) {
            return Err(damaged());
        }
        let end = content.windows(2).position(|pair| pair == b"\n\n").ok_or_else(damaged)?;
        let head = String::from_utf8_lossy(&content[..end + 2]);
        if let Some((found, expected)) = head.lines().zip(self.head.lines()).find(|(a, b)| a != b) {
            return Err(format!(
                "the checkpoint is that of another command: it has \"{found}\" where this command has \"{expected}\""
            ));
        }
        let mut reader = Reader { rest: &content[end + 2..] };
        let results = reader.results(plan).filter(|_| reader.rest.is_empty());
        results.ok_or_else(damaged)
    }

    /// Writes the checkpoint if the time of the next write has come. If the disk does not take it, the runs go on.
    pub fn write_in_time(&mut self, plan: &Plan, results: &Results) {
        if Instant::now() < self.next {
            return;
        }
        if let Err(failure) = self.write(plan, results) {
            self.next = Instant::now() + RENEWED;
            if !std::mem::replace(&mut self.is_refused, true) {
                say(&format!("warning: {failure}; the runs go on"));
            }
        }
    }

    /// What the checkpoint has, in words.
    pub fn kept(&self, plan: &Plan, results: &Results) -> String {
        let (runs, path) = (results.runs(plan), self.path.display());
        format!("{runs} of {} runs are in {path}: the same command continues from there", plan.runs)
    }

    pub fn write(&mut self, plan: &Plan, results: &Results) -> Result<(), Failure> {
        let began = Instant::now();
        let mut bytes = self.head.clone().into_bytes();
        put_results(&mut bytes, results);
        debug_assert_eq!(results.statistics.len(), plan.count());
        bytes.extend(checksum(&bytes).to_le_bytes());
        Outputs::new(&self.inputs, self.force).file(&self.path, MARK)?.finish(bytes)?;
        self.next = Instant::now() + RENEWED.max(WRITING * began.elapsed());
        Ok(())
    }

    /// Removes the checkpoint, after the results are written.
    pub fn remove(&self) -> Result<(), Failure> {
        match std::fs::remove_file(&self.path) {
            Err(error) if error.kind() != ErrorKind::NotFound => Err(Failure::of_output(&self.path, &error)),
            _ => Ok(()),
        }
    }
}

/// Description of the order, line by line.
fn head(given: &Given, plan: &Plan) -> Result<String, Failure> {
    let Plan { first_run, runs, every_s, requirements, .. } = plan;
    let scene = Scene { output: Output::default(), ..given.scene.clone() };
    let mut hash = Hash::default();
    // The format Debug has every field, and all digits of a number.
    let _ = write!(hash, "{scene:?} {}", given.count);
    if given.flight().is_none() {
        for index in 0..given.count {
            let _ = write!(hash, "{:?}", given.sample(index)?);
        }
    }
    let mut limits = Hash::default();
    let _ = write!(limits, "{requirements:?}");
    Ok(format!(
        "{MARK}\nversion {}\nscene {:016x}\nseed {}\nfirst run {first_run}\nruns {runs}\nblock {BLOCK}\n\
         seconds between rows {every_s:?}\nbytes of statistics {}\n\
         requirements {:016x}\n\n",
        env!("CARGO_PKG_VERSION"),
        hash.0,
        given.scene.options.key.seed,
        size_of::<Statistics>(),
        limits.0,
    ))
}

/// FNV-1a of 64 bits.
struct Hash(u64);

impl Default for Hash {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Write for Hash {
    fn write_str(&mut self, text: &str) -> std::fmt::Result {
        for byte in text.as_bytes() {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(0x100_0000_01b3);
        }
        Ok(())
    }
}

/// Eight bytes at a time: a file has megabytes. The last ones are padded with zeros, and the length is in the sum.
fn checksum(bytes: &[u8]) -> u64 {
    let (words, rest) = bytes.as_chunks();
    let mut last = [0; 8];
    last[..rest.len()].copy_from_slice(rest);
    let words = words.iter().chain([&last]).map(|word| u64::from_le_bytes(*word));
    words.fold(bytes.len() as u64, |hash, word| mix(hash ^ word))
}

/// Value that is written for a run without a state at the end.
const NO_STATE: State = [f64::NAN; 9];

fn put_results(to: &mut Vec<u8>, results: &Results) {
    let Results { done, statistics, ends, drawn, diverged, tracks, inside, beyond_range } = results;
    to.extend(done.iter().map(|done| u8::from(*done)));
    statistics.iter().for_each(|statistics| put_statistics(to, statistics));
    let put_state =
        |to: &mut Vec<u8>, state: &State| to.extend(state.iter().flat_map(|value| value.to_le_bytes()));
    ends.iter().for_each(|end| put_state(to, end.as_ref().unwrap_or(&NO_STATE)));
    put_count(to, diverged.len());
    to.extend(diverged.iter().flat_map(|run| run.to_le_bytes()));
    put_count(to, drawn.len());
    for path in drawn {
        put_count(to, path.len());
        path.iter().for_each(|state| put_state(to, state));
    }
    put_count(to, tracks.len());
    to.extend(tracks.iter().flat_map(|track| track.to_le_bytes()));
    to.extend(inside.iter().chain(beyond_range).flat_map(|runs| runs.to_le_bytes()));
}

fn put_statistics(to: &mut Vec<u8>, statistics: &Statistics) {
    let mut copy = *statistics;
    visit(&mut copy, &mut |number| match number {
        Word::Short(short) => to.extend(short.to_le_bytes()),
        Word::Long(long) => to.extend(long.to_le_bytes()),
    });
}

/// A number in statistics, of 32 or 64 bits.
enum Word<'a> {
    Short(&'a mut u32),
    Long(&'a mut u64),
}

/// Every number of statistics, in their order in memory.
fn visit(statistics: &mut Statistics, number: &mut dyn FnMut(Word<'_>)) {
    let Statistics {
        struct_size,
        layout,
        runs,
        diverged,
        out_of_range,
        outside_validity,
        largest_radial,
        sums,
        products,
        histogram,
        reserved,
    } = statistics;
    number(Word::Short(struct_size));
    number(Word::Short(layout));
    let counts = [runs, diverged, out_of_range, outside_validity, largest_radial];
    counts.into_iter().chain(sums).chain(products).for_each(|long| number(Word::Long(long)));
    histogram.iter_mut().for_each(|short| number(Word::Short(short)));
    number(Word::Short(reserved));
}

fn put_count(to: &mut Vec<u8>, count: usize) {
    to.extend((count as u64).to_le_bytes());
}

/// Reads the results back; `None` if the bytes do not contain them.
struct Reader<'a> {
    rest: &'a [u8],
}

impl Reader<'_> {
    fn results(&mut self, plan: &Plan) -> Option<Results> {
        let done = self.take(plan.blocks())?.iter().map(|done| *done != 0).collect();
        let statistics = (0..plan.count()).map(|_| self.statistics()).collect::<Option<_>>()?;
        let ends = (0..plan.runs).map(|_| self.state()).collect::<Option<Vec<State>>>()?;
        let ends = ends.into_iter().map(|end| Some(end).filter(|end| !end[0].is_nan())).collect();
        let diverged = (0..self.count(plan.runs)?).map(|_| self.number()).collect::<Option<_>>()?;
        let path = |reader: &mut Self| {
            let count = reader.count(plan.instants.len() as u64)?;
            (0..count).map(|_| reader.state()).collect()
        };
        let drawn = (0..self.count(plan.drawn())?).map(|_| path(self)).collect::<Option<_>>()?;
        let tracks = self.count(plan.instants.len() as u64)?;
        let tracks = (0..tracks).map(|_| self.number().map(f64::from_bits)).collect::<Option<_>>()?;
        let inside = plan.requirements.iter().map(|_| self.number()).collect::<Option<_>>()?;
        let beyond_range = [self.number()?, self.number()?];
        Some(Results { done, statistics, ends, drawn, diverged, tracks, inside, beyond_range })
    }

    fn take(&mut self, size: usize) -> Option<&[u8]> {
        let (taken, rest) = self.rest.split_at_checked(size)?;
        self.rest = rest;
        Some(taken)
    }

    fn number(&mut self) -> Option<u64> {
        Some(u64::from_le_bytes(self.take(8)?.try_into().ok()?))
    }

    /// A count up to `most`.
    fn count(&mut self, most: u64) -> Option<u64> {
        self.number().filter(|count| *count <= most)
    }

    fn state(&mut self) -> Option<State> {
        let mut state = [0.0; 9];
        for value in &mut state {
            *value = f64::from_bits(self.number()?);
        }
        Some(state)
    }

    /// Statistics, if they pass the check of the library.
    fn statistics(&mut self) -> Option<Statistics> {
        let mut bytes = self.take(size_of::<Statistics>())?;
        let mut statistics = Statistics::EMPTY;
        visit(&mut statistics, &mut |number| match number {
            Word::Short(short) => *short = u32::from_le_bytes(next(&mut bytes)),
            Word::Long(long) => *long = u64::from_le_bytes(next(&mut bytes)),
        });
        statistics.check().ok().map(|()| statistics)
    }
}

/// The next bytes; zeros if there are no more.
fn next<const N: usize>(bytes: &mut &[u8]) -> [u8; N] {
    let Some((first, rest)) = bytes.split_first_chunk() else { return [0; N] };
    *bytes = rest;
    *first
}
