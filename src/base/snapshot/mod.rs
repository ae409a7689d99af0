//! Snapshots: the state of a simulator, or of an ensemble, as bytes that mean the same on every machine.
//!
//! ```text
//!  0   8  "SINSsnap", of an ensemble "SINSruns", of a unit "SINSunit", of a scene in flight "SINSplay"
//!  8   4  version of the format
//! 12   4  length of the whole [bytes], its lowest 32 bits
//! 16   8  checksum of all the other bytes
//! 24      words of 64 bits
//! ```
//! The least significant byte comes first. Sixteen bits precede each group of eight words, two bits for each word, lowest first: 0
//! if the word is zero and left out, 1 if it is below 256 and follows as one byte, 2 if it follows as eight bytes. So a value that
//! is off takes two bits. Floating-point numbers are stored as their IEEE 754 bits. After the header of a simulator's snapshot come
//! the options, the sensors' parameters and state, the samples, and the chain, each part in the order in which its `stored!` names
//! the fields. A snapshot of an ensemble has its options, samples, first run and number of runs, then each run as a simulator.
//! Values that follow from others are not stored, but computed again.
//!
//! Everything is checked: the header, each number against a limit, and options, parameters and samples as if the host had
//! given them. The checksum misses one of 2^64 alterations. False numbers with a correct checksum are
//! rejected too, or they are the state of a working simulator.

mod envelope;
mod numbers;
mod reader;
mod stored;
mod writer;

pub use envelope::{FORMAT_VERSION, SnapshotOf, seal};
pub(crate) use numbers::{ANY, CLOCK_S, COUNT, NO_SQUARE, Numbers, SIGNALS, WALKS, moved_clock};
pub(crate) use reader::Reader;
pub(crate) use stored::{Stored, codes, stored, variants};
pub(crate) use writer::{Writer, fitting};
