//! What a host and its machine do to the library: programs in C, built and run. `tests/README.md` has the table.

#[path = "support/c_side.rs"]
mod c_side;

use c_side::{library_folder, run_test_program, succeed, test_program};

#[test]
fn misuse_of_every_function_is_answered() {
    run_test_program("misuse");
}

#[test]
fn threads_are_serialised_by_handle() {
    run_test_program("threads");
}

#[test]
fn the_hosts_floating_point_state_does_not_matter_and_is_kept() {
    run_test_program("float_environment");
}

#[test]
fn a_real_time_frame_makes_no_allocation_and_no_system_call() {
    run_test_program("real_time");
}

#[test]
fn the_library_comes_and_goes_and_two_copies_of_it_are_strangers() {
    let folder = library_folder("unload");
    let copies = ["libsins.so", "libsins.so.1"].map(|name| folder.join(name));
    succeed(test_program("unload", &folder).args(copies));
}
