//! Calls of a master: corrections, wrong calls, calls in random order, the URI of the resources.

mod corrections;
mod misuse;
mod panel;
mod random_calls;
mod support;
mod uri;
