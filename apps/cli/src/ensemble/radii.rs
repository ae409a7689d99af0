//! CEP50 and R95 at the end with their intervals, in one sentence.

use super::plan::Data;
use super::study::Study;
use super::table::radial;
use crate::units::{LENGTH, time_text, with_unit};

/// Probability that a quantile is below its interval, and that it is above.
const TAIL: f64 = 0.025;

/// How far half and 95 % of the runs are off at the end.
pub fn sentence(study: &Study) -> String {
    let after = time_text(study.given.duration_s);
    let mut radii: Vec<f64> = study.ends().map(radial).collect();
    radii.sort_unstable_by(f64::total_cmp);
    let figures = study.end(Data::Navigation).map(|row| &row.figures);
    let (Some(figures), [first, ..]) = (figures, &radii[..]) else {
        return format!("None of the runs reached the end of {after}.");
    };
    let (runs, left) = (study.plan.runs, radii.len());
    let lost = study.results.diverged.len();
    if left == 1 {
        let of = if runs == 1 {
            "the only run".to_owned()
        } else {
            format!("the only one of {runs} runs that did not diverge")
        };
        return format!("After {after} the INS is {} off in {of}.", with_unit(*first, LENGTH));
    }
    let of = |name: &str, radius_m: f64, share: f64| {
        let interval = interval(&radii, share);
        // Figures of centimetres are rounded to classes of half a millimetre, the values of the interval are not.
        let found = with_unit(radius_m.clamp(interval.0, interval.1.unwrap_or(f64::INFINITY)), LENGTH);
        let between = match interval {
            (low, Some(high)) => format!("{} to {}", with_unit(low, LENGTH), with_unit(high, LENGTH)),
            (low, None) => {
                format!("more than {}, the runs are too few for an upper end", with_unit(low, LENGTH))
            }
        };
        format!("within {found} of the truth ({name}; {between})")
    };
    let of_which = match lost {
        0 => format!("After {after} half of the {left} runs"),
        _ => format!("{lost} of the {runs} runs diverged. After {after} half of the other {left}"),
    };
    format!(
        "{of_which} are {}, and 95 % {}, with intervals of 95 % confidence.",
        of("CEP50", figures.cep50_m, 0.5),
        of("R95", figures.r95_m, 0.95)
    )
}

/// Interval that contains the quantile `share` of the distribution of `sorted` with 95 % confidence, whatever the distribution. Of n values
/// the number k below the quantile is binomial:
/// ```text
/// P(k) = n! / (k! (n-k)!) p^k (1-p)^(n-k)
/// ```
/// `None`: so few values have no upper end; the lower end is then 0 or a value.
fn interval(sorted: &[f64], share: f64) -> (f64, Option<f64>) {
    let n = sorted.len();
    let (mut log_choose, mut at_most) = (0.0, 0.0);
    let (mut low, mut high) = (None, None);
    for below in 0..=n {
        if below > 0 {
            log_choose += ((n + 1 - below) as f64 / below as f64).ln();
        }
        at_most += (log_choose + below as f64 * share.ln() + (n - below) as f64 * (-share).ln_1p()).exp();
        if low.is_none() && at_most > TAIL {
            low = Some(below);
        }
        if high.is_none() && at_most >= 1.0 - TAIL {
            high = Some(below);
        }
    }
    // The value of rank k, 1 to n, is above the quantile unless at least k values are below it.
    let low_m = low.and_then(|rank| rank.checked_sub(1)).map_or(0.0, |place| sorted[place]);
    (low_m, high.and_then(|place| sorted.get(place)).copied())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn uniform(count: usize, random: &mut u64) -> Vec<f64> {
        let mut next = || {
            *random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (*random >> 11) as f64 / (1_u64 << 53) as f64
        };
        let mut values: Vec<f64> = (0..count).map(|_| next()).collect();
        values.sort_unstable_by(f64::total_cmp);
        values
    }

    /// Of uniform numbers the quantile is the share itself: the intervals contain it as often as they say. 4000 trials have a scatter
    /// of 0.35 %; an interval between ranks contains it at least as often as 95 %.
    #[test]
    fn intervals_hold() {
        const TRIALS: usize = 4000;
        let (mut random, mut least, mut most) = (1, 100.0_f64, 0.0_f64);
        for (count, share) in [(20, 0.5), (50, 0.5), (200, 0.5), (200, 0.95), (100, 0.95)] {
            let hits = (0..TRIALS).filter(|_| {
                let (low, high) = interval(&uniform(count, &mut random), share);
                low <= share && high.is_none_or(|high| share <= high)
            });
            let fraction = hits.count() as f64 / TRIALS as f64;
            assert!((0.94..0.985).contains(&fraction), "{count} {share}: {fraction}");
            (least, most) = (least.min(100.0 * fraction), most.max(100.0 * fraction));
        }
        println!(
            "figure: CEP50 and R95 with intervals of ranks, which hold in {least:.1} to {most:.1} % of {TRIALS} trials"
        );
    }

    /// Ranks of published tables: of 50 values the median is between the 18th and the 33rd, of 100 between the 40th and the 61st.
    #[test]
    fn ranks_are_those_of_tables() {
        let ranks = |count: usize| (1..=count).map(|rank| rank as f64).collect::<Vec<_>>();
        assert_eq!(interval(&ranks(50), 0.5), (18.0, Some(33.0)));
        assert_eq!(interval(&ranks(100), 0.5), (40.0, Some(61.0)));
        // All of 71 values are below the 95th percentile with a probability of more than 2.5 %: 0.95^71 = 2.6 %.
        assert!(interval(&ranks(71), 0.95).1.is_none() && interval(&ranks(72), 0.95).1 == Some(72.0));
        assert_eq!(interval(&ranks(3), 0.5), (0.0, None));
    }
}
