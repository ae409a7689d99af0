//! Heights that are asked about: below any land, of the ground, without a unit among those of pilots.

use super::conventions::{Row, assert_asks, doubts_of, errors, flight, look, table};

fn place(row: &Row) -> String {
    format!("{:.9},{:.9}", row[1], row[2])
}

/// A height that counts down is asked about where no land is as deep; a flight over the Dead Sea is not.
#[test]
fn a_height_below_any_land_is_asked_about() {
    let rows = flight(31.5, 35.5);
    let of = |height: &dyn Fn(&Row) -> f64| {
        table("time,lat,lon,height (m)", &rows, |_, row| {
            format!("{:.1},{},{:.2}", row[0], place(row), height(row))
        })
    };
    let found = assert_asks(&of(&|row| -row[3] - 200.0), "below any land");
    assert!(found.questions[0].answers[0].contains("sign = -1"), "{found:?}");
    let (found, samples) = look(&of(&|row| row[3] - 900.0));
    assert!(samples.is_ok() && found.questions.is_empty(), "{found:?}");
    let in_feet = |height_ft: f64| of(&|_| height_ft).replace("height (m)", "height (ft)");
    let (found, samples) = look(&in_feet(-1250.0));
    assert!(samples.is_ok() && found.questions.is_empty(), "{found:?}");
    let found = assert_asks(&in_feet(-3000.0), "below any land: -914 m");
    assert!(found.questions[0].answers[0].contains("unit = \"ft\", sign = -1"), "{found:?}");
}

#[test]
fn an_elevation_beside_an_altitude_is_asked_about() {
    let rows = flight(47.3, 8.4);
    let text = table("time,lat,lon,Altitude (ft AGL),Elevation (ft)", &rows, |_, row| {
        format!("{:.1},{},{:.1},{:.1}", row[0], place(row), row[3], 1200.0 + row[0])
    });
    assert_asks(&text, "Elevation (ft) may be that of the ground, beside Altitude (ft AGL)");
    let alone = table("time,lat,lon,elevation (m)", &rows, |_, row| {
        format!("{:.1},{},{:.2}", row[0], place(row), row[3])
    });
    let (found, samples) = look(&alone);
    assert!(found.questions.is_empty() && errors(&samples.unwrap(), &rows).0 < 0.01, "{found:?}");
}

/// Where speeds are in knots or climbs in feet per minute, a height without a unit may be in feet, or in flight levels.
#[test]
fn a_height_without_a_unit_beside_knots_is_asked_about() {
    let rows = flight(47.3, 8.4);
    let of = |names: &str, size: f64| {
        table(names, &rows, |_, row| {
            format!("{:.1},{},{:.2},{:.2}", row[0], place(row), row[3] / size, row[4] / 0.514_444)
        })
    };
    let found = assert_asks(&of("time,lat,lon,altitude,gs (kt)", 0.3048), "knots or feet per minute");
    let answers = found.questions[0].answers.len();
    let levels = assert_asks(&of("time,lat,lon,altitude,gs (kt)", 30.48), "scale = 30.48");
    assert_eq!(levels.questions[0].answers.len(), answers + 1, "{found:?} {levels:?}");
    for names in ["time,lat,lon,altitude (ft),gs (kt)", "time,lat,lon,altitude,gs"] {
        let (found, _) = look(&of(names, 0.3048));
        assert!(found.questions.is_empty(), "{names}: {found:?}");
        assert!(names.contains("ft") || doubts_of(&found, "nothing states its unit"), "{found:?}");
    }
}
