//! Calls of a master: wrong calls, calls in random order, the URI of the resources.

mod misuse;
mod random_calls;
mod support;
mod uri;
