//! Normal numbers by the ziggurat method.

use rand::distr::Open01;
use rand::{Rng, RngExt};
use rand_distr::Distribution;

use super::xoshiro::Xoshiro256PlusPlus;
use crate::base::math::{exp, ln};
use crate::signal::{RUNS, Row};

/// Normal with mean 0 and variance 1: Doornik, "An Improved Ziggurat Method to Generate Normal Random Samples", 2005 (ZIGNOR),
/// with the widths and bits of [`rand_distr::StandardNormal`].
///
/// Departure: it is not that distribution itself, which uses the logarithm and the exponential of the platform as soon as any crate of
/// the build asks `num-traits` for its `std`. Ensembles need the same numbers for the runs of a batch.
#[derive(Debug, Clone, Copy)]
pub struct StandardNormal;

impl Distribution<f64> for StandardNormal {
    #[inline]
    fn sample<R: Rng + ?Sized>(&self, generator: &mut R) -> f64 {
        let word = generator.next_u64();
        let (x, is_inside) = of_word(word);
        if is_inside { x } else { at_an_edge(word, generator) }
    }
}

/// [`StandardNormal`] of a stream.
#[inline]
pub(super) fn normal(generator: &mut Xoshiro256PlusPlus) -> f64 {
    let word = generator.next_u64();
    let (x, is_inside) = of_word(word);
    if is_inside {
        return x;
    }
    // The generator is passed by value. By reference, the state of the generator would be in memory throughout.
    let (x, later) = passed_on(word, generator.clone());
    *generator = later;
    x
}

#[cold]
#[inline(never)]
fn passed_on(word: u64, mut generator: Xoshiro256PlusPlus) -> (f64, Xoshiro256PlusPlus) {
    (at_an_edge(word, &mut generator), generator)
}

/// From 2 up to but excluding 4, of the upper 52 bits of the word.
#[inline(always)]
fn from_two(word: u64) -> f64 {
    f64::from_bits(2.0f64.to_bits() | (word >> 12))
}

/// The number that one word gives, and whether this word alone decides it.
#[inline(always)]
fn of_word(word: u64) -> (f64, bool) {
    let (layer, u) = layer_and_share(word);
    let x = u * X[layer];
    (x, x.abs() < X[layer + 1])
}

/// The next normal number of each generator of a batch. The states of the generators are in four rows.
#[inline(always)]
pub(super) fn normal_each(states: &mut [[u64; RUNS]; 4]) -> Row {
    let (mut numbers, mut words, mut is_at_edge, mut any_edge) = ([0.0; RUNS], [0; RUNS], [0; RUNS], 0);
    for lane in 0..RUNS {
        let mut generator = Xoshiro256PlusPlus::of_words([0, 1, 2, 3].map(|i: usize| states[i][lane]));
        words[lane] = generator.next_u64();
        let state = generator.words();
        for i in 0..4 {
            states[i][lane] = state[i];
        }
    }
    for lane in 0..RUNS {
        let (x, is_inside) = of_word(words[lane]);
        numbers[lane] = x;
        is_at_edge[lane] = u64::from(!is_inside);
        any_edge |= is_at_edge[lane];
    }
    if any_edge != 0 {
        at_the_edges(states, &words, &is_at_edge, &mut numbers);
    }
    numbers
}

/// Draws further words for the runs whose first word does not decide the number.
#[inline(never)]
fn at_the_edges(
    states: &mut [[u64; RUNS]; 4],
    words: &[u64; RUNS],
    is_at_edge: &[u64; RUNS],
    numbers: &mut Row,
) {
    for lane in (0..RUNS).filter(|&lane| is_at_edge[lane] != 0) {
        let generator = Xoshiro256PlusPlus::of_words([0, 1, 2, 3].map(|i: usize| states[i][lane]));
        let (x, later) = passed_on(words[lane], generator);
        numbers[lane] = x;
        for (row, word) in states.iter_mut().zip(later.words()) {
            row[lane] = word;
        }
    }
}

/// A layer, and a position in it as a share of its half width, from -1 up to but excluding 1.
#[inline(always)]
fn layer_and_share(word: u64) -> (usize, f64) {
    ((word & 0xff) as usize, from_two(word) - 3.0)
}

/// The number for a first word that does not decide it. This happens in one draw of 67.
fn at_an_edge<R: Rng + ?Sized>(word: u64, generator: &mut R) -> f64 {
    let (mut layer, mut u) = layer_and_share(word);
    loop {
        let x = u * X[layer];
        if x.abs() < X[layer + 1] {
            return x;
        }
        if layer == 0 {
            return tail(generator).copysign(u);
        }
        if under_the_curve(x, layer, generator.random()) {
            return x;
        }
        (layer, u) = layer_and_share(generator.next_u64());
    }
}

/// A number of the tail, which is the part of the lowest layer beyond X[1] (Marsaglia 1964): x from X[1] on, with the density
/// exp(-x²/2).
fn tail<R: Rng + ?Sized>(generator: &mut R) -> f64 {
    loop {
        let beyond = -ln(generator.sample(Open01)) / X[1];
        let height: f64 = generator.sample(Open01);
        if -2.0 * ln(height) >= beyond * beyond {
            return X[1] + beyond;
        }
    }
}

/// Whether the point at `x`, at the share `height` of the height of its layer, is under the curve exp(-x²/2). Heights are in units
/// of the curve's height at `x`.
fn under_the_curve(x: f64, layer: usize, height: f64) -> bool {
    let [bottom, top] = [X[layer], X[layer + 1]].map(|width| exp(-0.5 * (width * width - x * x)));
    top + height * (bottom - top) < 1.0
}

/// Half widths of the layers, which have equal areas. X[0] belongs to the lowest layer with its tail, which begins at X[1]. The
/// last one is 0, at the peak.
#[rustfmt::skip]
static X: [f64; 257] = [
    3.91075795953709, 3.654152885361009, 3.4492782985609645, 3.320244733839166, 3.224575052047029,
    3.14788928951715, 3.083526132001233, 3.0278377917686354, 2.978603279880845, 2.9343668672078542,
    2.894121053612348, 2.8571387308721325, 2.822877396825325, 2.7909211740007858, 2.7609440052788226,
    2.732685359042827, 2.705933656121858, 2.680514643284522, 2.6562830375755024, 2.6331163936303246,
    2.6109105184875485, 2.589575986706995, 2.5690354526805366, 2.5492215503234608, 2.530075232158517,
    2.5115444416253423, 2.4935830412696807, 2.4761499396691433, 2.4592083743333113, 2.4427253181989568,
    2.426670984935726, 2.4110184138996855, 2.3957431197804806, 2.380822795170626, 2.3662370567158186,
    2.35196722737766, 2.3379961487950314, 2.324308018869623, 2.31088825059985, 2.2977233489013296,
    2.284800802722946, 2.272108990226824, 2.259637095172218, 2.2473750329458078, 2.235313384928328,
    2.2234433400909057, 2.2117566428825444, 2.200245546609648, 2.1889027716247207, 2.1777214677386416,
    2.166695180352646, 2.1558178198750633, 2.1450836340462036, 2.13448718284432, 2.1240233156878157,
    2.113687150684934, 2.103474055713147, 2.0933796311370503, 2.083399693996552, 2.0735302635169788,
    2.0637675478099564, 2.054107931648865, 2.044547965215733, 2.0350843537278087, 2.025713947862033,
    2.0164337349043717, 2.007240830558685, 1.9981324713565642, 1.9891060076155713, 1.9801588968985984,
    1.9712886979317696, 1.962493064942462, 1.953769742382734, 1.945116560006754, 1.936531428273759,
    1.9280123340507183, 1.9195573365912288, 1.9111645637692822, 1.9028322085484464, 1.89455852566871,
    1.8863418285347764, 1.8781804862909777, 1.8700729210692368, 1.8620176053976323, 1.8540130597581481,
    1.8460578502831198, 1.8381505865807286, 1.8302899196806666, 1.8224745400917832, 1.8147031759641676,
    1.8069745913486934, 1.7992875845475802, 1.79164098655001, 1.7840336595472763, 1.776464495522345,
    1.768932414909078, 1.7614363653167067, 1.753975320315455, 1.746548278279493, 1.739154261283669,
    1.7317923140507072, 1.7244615029457757, 1.7171609150155407, 1.709889657069006, 1.702646854797614,
    1.6954316519322385, 1.6882432094348587, 1.6810807047228233, 1.6739433309237604, 1.6668302961592867,
    1.6597408228557895, 1.6526741470806485, 1.6456295179023603, 1.6386061967731111, 1.631603456932422,
    1.6246205828305684, 1.6176568695705342, 1.6107116223673337, 1.603784156023583, 1.5968737944202613,
    1.5899798700216485, 1.5831017233934714, 1.5762387027333329, 1.5693901634125345, 1.5625554675284397,
    1.555733983466555, 1.5489250854715355, 1.5421281532263476, 1.5353425714388431, 1.5285677294350246,
    1.521803020758293, 1.5150478427739924, 1.508301596278572, 1.5015636851127065, 1.4948335157777184,
    1.4881104970546544, 1.4813940396253757, 1.4746835556950255, 1.467978458615231, 1.4612781625074078,
    1.4545820818855233, 1.4478896312776697, 1.441200224845798, 1.4345132760029464, 1.4278281970272904,
    1.4211443986723231, 1.4144612897724647, 1.4077782768433715, 1.4010947636762026, 1.3944101509250713,
    1.3877238356868846, 1.381035211072742, 1.3743436657700305, 1.367648583594318, 1.3609493430301018,
    1.3542453167594306, 1.3475358711773593, 1.3408203658931521, 1.3340981532160836, 1.3273685776246247,
    1.32063097521773, 1.313884673146869, 1.3071289890273539, 1.3003632303274337, 1.2935866937335176,
    1.2867986644897864, 1.2799984157103332, 1.2731852076618437, 1.2663582870146883, 1.2595168860601442,
    1.2526602218912979, 1.245787495544998, 1.2388978911020274, 1.231990574742445, 1.225064693752808,
    1.2181193754817266, 1.2111537262399112, 1.2041668301405601, 1.197157747875586, 1.1901255154228016,
    1.1830691426787607, 1.1759876120114898, 1.1688798767268338, 1.1617448594415742, 1.1545814503558518,
    1.1473885054167339, 1.1401648443639958, 1.132909248648337, 1.1256204592112944, 1.118297174115063,
    1.1109380460092495, 1.1035416794202682, 1.0961066278476035, 1.0886313906495142, 1.0811144096988894,
    1.0735540657878717, 1.0659486747575067, 1.0582964833260065, 1.0505956645862071, 1.0428443131393705,
    1.0350404398286053, 1.0271819660307513, 1.0192667174605292, 1.0112924174349784, 1.0032566795395914,
    0.9951569996299431, 0.9869907470938463, 0.9787551552889378, 0.9704473110588646, 0.9620641432176052,
    0.9536024098755727, 0.9450586844625711, 0.9364293402808969, 0.9277105333962348, 0.918898183643735,
    0.909987953490769, 0.9009752244551745, 0.8918550707267924, 0.8826222295789101, 0.8732710680824946,
    0.8637955455468269, 0.8541891710015606, 0.8444449549024237, 0.8345553540795188, 0.8245122087452886,
    0.8143066701280643, 0.8039291169826649, 0.7933690588331528, 0.7826150232995888, 0.7716544242167394,
    0.7604734064220832, 0.7490566620095817, 0.7373872114258386, 0.7254461409013035, 0.7132122851820227,
    0.7006618410975844, 0.6877678927862577, 0.6744998228274365, 0.660822574234206, 0.6466957148843889,
    0.6320722363750246, 0.6168969899962355, 0.6011046177439404, 0.5846167660937223, 0.567338257040473,
    0.5491517023130268, 0.5299097206464951, 0.5094233295859334, 0.48744396612175434, 0.46363433677176324,
    0.43751840218666266, 0.40838913458800075, 0.3751213328504657, 0.33573751918045946, 0.2861745917472605,
    0.2152418959132738, 0.0,
];

#[cfg(test)]
mod tests {
    use rand::SeedableRng;

    use super::*;

    const EPS: f64 = f64::EPSILON;

    /// A million numbers of the tail, each compared with R - ln(u) / R with the portable logarithm. The platform's logarithm
    /// differs. A crate of the build that asks a dependency for the platform's logarithm must not change the numbers.
    #[test]
    fn the_tail_has_the_portable_logarithm() {
        let mut seed = Xoshiro256PlusPlus::seed_from_u64(1);
        for k in 0..1_000_000 {
            // The lowest layer, at either of its ends.
            let word = [0, !0xff][k % 2];
            let mut generator = Xoshiro256PlusPlus::about_to_give(word, &mut seed);
            let mut replay = generator.clone();
            let x = normal(&mut generator);

            assert_eq!(replay.next_u64(), word);
            loop {
                let [u, v] = [0, 1].map(|_| (2.0 * (replay.next_u64() >> 12) as f64 + 1.0) * (0.5 * EPS));
                let beyond = -libm::log(u) / X[1];
                let taken = -2.0 * libm::log(v) >= beyond * beyond;
                assert_eq!(taken, replay == generator);
                if taken {
                    assert_eq!(x, [-1.0, 1.0][k % 2] * (X[1] + beyond));
                    break;
                }
            }
        }
    }

    /// `rand_distr` makes the same number from the same words. Numbers of the tail are compared to within rounding, because its
    /// logarithm may differ: by an ulp of the logarithm, the division and the addition.
    #[test]
    fn it_is_the_ziggurat_of_the_reference() {
        let mut seed = Xoshiro256PlusPlus::seed_from_u64(2);
        for k in 0..4_000_000 {
            let mut ours = seed.clone();
            if k % 2 == 0 {
                // An end of a layer, where the curve decides.
                let end = seed.next_u64() >> 8;
                ours = Xoshiro256PlusPlus::about_to_give([end, !end][k / 2 % 2], &mut seed);
            }
            let (mut theirs, mut of_trait) = (ours.clone(), ours.clone());
            let x = normal(&mut ours);
            let expected: f64 = rand_distr::StandardNormal.sample(&mut theirs);
            assert!(x == expected || (x - expected).abs() <= 2.0 * EPS * x.abs() && x.abs() > X[1]);
            assert_eq!(ours, theirs);
            assert_eq!((StandardNormal.sample(&mut of_trait), of_trait), (x, ours));
            seed.next_u64();
        }
    }
}
