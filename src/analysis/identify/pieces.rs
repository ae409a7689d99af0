//! A large jump of the clock, before any fit: the pieces of the record before and behind it have shifts of their own.

use nalgebra::{Matrix3, Vector3};

use super::axes::{Axes, SAME};
use super::blocks::Block;
use super::clock::{PARTS, Search, Shift, refine};
use super::jump::Jump;
use super::path::{IdealPath, Six};
use crate::base::error::Error;

/// Fewest cells of a part of a record whose clock is searched for two shifts.
const FEWEST_CELLS: usize = 50;
/// Two shifts are a jump if they leave at most this part of the motion that one shift leaves unexplained.
const OF_ONE: f64 = 0.25;
/// The least part of the motion that one shift leaves unexplained at such a jump; a smaller jump is found by the fit.
const MUCH: f64 = 0.02;
/// A large jump, before any fit: two shifts, one after the other, with which the rates are those of the path, and which leave a part of
/// what the best single shift leaves.
pub(super) fn large(search: &Search, path: &IdealPath, blocks: &[Block]) -> Result<Option<Jump>, Error> {
    if search.recorded.len() < PARTS * FEWEST_CELLS {
        return Ok(None);
    }
    let both = |(split, lags): &(usize, [usize; 2])| {
        let (before, behind) = (search.sum(lags[0], 0..*split), search.sum(lags[1], *split..PARTS));
        search.score_of(&before.plus(&behind), 0..PARTS)
    };
    let splits = (1..PARTS).map(|split| (split, [search.best(&(0..split)), search.best(&(split..PARTS))]));
    let Some((split, lags)) = splits.max_by(|a, b| both(a).total_cmp(&both(b))) else { return Ok(None) };
    let border = search.first_cell(split);
    let (one, of_one) = correlation(search, [search.best(&(0..PARTS)); 2], border);
    let (two, of_two) = correlation(search, lags, border);
    // A shift that fits where it brings the record outside the path leaves much, if time goes on along the path at two.
    let has_signal = |cell: &usize| search.recorded[*cell].0 > 0.0;
    let last = (0..border).rev().find(has_signal).map(|cell| cell + lags[0]);
    let next = (border..search.recorded.len()).find(has_signal).map(|cell| cell + lags[1]);
    let in_common = if next >= last { (of_one / of_two).min(1.0) } else { 1.0 };
    let (left_of_one, left_of_two) = (1.0 - one * one * in_common, 1.0 - two * two);
    if two < SAME || left_of_one < MUCH || left_of_two > OF_ONE * left_of_one {
        return Ok(None);
    }
    let border_s = search.first_s + border as f64 * search.cell_s;
    let behind = blocks.partition_point(|block| block.middle_s() < border_s);
    let shifts = lags.map(|lag| Shift { offset_s: search.offset_s(lag), score: 0.0 });
    let before = refine(path, &blocks[..behind], shifts[0], search.cell_s);
    let after = refine(path, &blocks[behind..], shifts[1], search.cell_s);
    Ok(Some(Jump { behind, change_s: after.offset_s - before.offset_s }))
}

/// Correlation of the rates, in the best exchange of axes, at one shift before the cell `border` and another one behind it, and the number
/// of cells of which it is.
fn correlation(search: &Search, lags: [usize; 2], border: usize) -> (f64, f64) {
    let rates = |cell: &(f64, Six)| cell.1.fixed_rows::<3>(0).into_owned();
    let pairs = || {
        (0..search.recorded.len()).filter_map(|cell| {
            let place = search.place(cell, lags[usize::from(cell >= border)])?;
            let (m, u) = (&search.recorded[cell], &search.ideal[place]);
            (m.0 > 0.0 && u.0 > 0.0).then(|| (rates(m), rates(u)))
        })
    };
    let count = pairs().count().max(1) as f64;
    let means = pairs().fold([Vector3::zeros(); 2], |sum, (m, u)| [sum[0] + m / count, sum[1] + u / count]);
    let (mut cross, mut squares) = (Matrix3::zeros(), [0.0; 2]);
    for (m, u) in pairs() {
        let (m, u) = (m - means[0], u - means[1]);
        cross += m * u.transpose();
        squares[0] += m.norm_squared();
        squares[1] += u.norm_squared();
    }
    let along = Axes::exchanges().map(|axes| axes.component_mul(&cross).sum()).fold(0.0, f64::max);
    let size = (squares[0] * squares[1]).sqrt();
    (if size > 0.0 { along / size } else { 0.0 }, count)
}
