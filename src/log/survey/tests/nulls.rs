//! Positions near 0, 0: small angles, and rows without a fix.

use super::conventions::{Row, assert_asks, doubts_of, errors, flight, look, table};

#[test]
fn degrees_near_0_0_are_told_from_radians_by_the_speed_or_asked_about() {
    for (latitude, longitude) in [(0.3, 0.4), (-0.001, 0.002), (0.0001, -3.0)] {
        let rows = flight(latitude, longitude);
        for size in [1.0, 1.0_f64.to_radians()] {
            let place = |row: &Row| format!("{:.11},{:.11},{:.3}", row[1] * size, row[2] * size, row[3]);
            let text = table("t,lat,lon,alt,speed (m/s),course", &rows, |_, row| {
                format!("{:.1},{},40,{:.1}", row[0], place(row), row[5])
            });
            let (found, samples) = look(&text);
            assert!(found.questions.is_empty(), "{found:?}");
            assert!(errors(&samples.unwrap(), &rows).0 < 0.01, "{latitude} {size}: {found:?}");
        }
        // 40 m/s in degrees would be 2292 m/s in radians; a walk is both.
        let text = |size: f64| {
            table("t,lat,lon,alt", &rows, |_, row| {
                format!("{:.1},{:.11},{:.11},{:.3}", row[0] * size, row[1], row[2], row[3])
            })
        };
        assert!(errors(&look(&text(1.0)).1.unwrap(), &rows).0 < 0.01);
        let found = assert_asks(&text(4.0), "are small: degrees or radians?");
        assert!(found.questions[0].answers.len() == 2 && !found.text.contains("latitude"), "{found:?}");
    }
    // Nothing moves.
    let rest: String = (0..40).map(|index| format!("{index},0.8377,0.19,300\n")).collect();
    assert_asks(&format!("t,lat,lon,alt\n{rest}"), "degrees or radians");
}

#[test]
fn rows_at_0_0_before_the_first_fix_are_left_out() {
    for size in [1.0, 1.0_f64.to_radians()] {
        let rows = flight(47.3, 8.4);
        let unit = if size == 1.0 { "deg" } else { "rad" };
        let text = |is_without: fn(usize) -> bool| {
            table(&format!("t,lat ({unit}),lon ({unit}),alt (m)"), &rows, |index, row| {
                let place = if is_without(index) { [0.0; 2] } else { [row[1] * size, row[2] * size] };
                format!("{:.1},{:.10},{:.10},{:.3}", row[0], place[0], place[1], row[3])
            })
        };
        let (found, samples) = look(&text(|index| index < 51));
        assert!(doubts_of(&found, "the first 51 rows are left out"), "{found:?}");
        assert!(errors(&samples.unwrap(), &rows[51..]).0 < 0.01, "{found:?}");
        let (found, _) = look(&text(|index| index == 100));
        assert!(
            doubts_of(&found, "1 row has the position 0, 0 behind") && !found.text.contains("skip"),
            "{found:?}"
        );
        let (found, _) = look(&text(|_| true));
        assert!(doubts_of(&found, "0, 0 in each row"), "{found:?}");
    }
    // A flight that begins there keeps its first row.
    let rows = flight(0.0, 0.0);
    let text = table("t,lat (deg),lon (deg),alt (m)", &rows, |_, row| {
        format!("{:.1},{:.10},{:.10},{:.3}", row[0], row[1], row[2], row[3])
    });
    assert!(errors(&look(&text).1.unwrap(), &rows).0 < 0.01);
}
