//! Calls of a master: corrections, parts of intervals, wrong calls, calls in random order, the URI of the resources, a doubtful truth.

mod corrections;
mod misuse;
mod panel;
mod parts;
mod random_calls;
mod support;
mod uri;
mod watch;
