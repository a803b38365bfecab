//! Measured reflectance as lobes under a table of factors, which is how it is drawn.
//!
//! A sum of few lobes is fitted, and the data over it, which vary little, go into a table over half and difference angles.
//! Its channels are mixtures of few of them, the ranks. So each fitted lobe becomes as many as there are ranks: shape times
//! rank times a tint that holds all that is colour.

mod carrier;
mod judge;
mod positive;
mod ranks;
mod smooth;
mod smoothed;

use std::sync::Arc;

use glanz_bsdf::{DirectionPair, FactorTable, LayerWeight, Shape};
use glanz_math::Vec3;

use crate::{Channels, FitError, Measured};
use carrier::Carrier;
use judge::Judge;
use positive::Positive;
use ranks::{Columns, Ranked};
pub use smoothed::Smoothed;
use smoothed::turned;

/// Nodes along the axes of the tables of isotropic surfaces, and of those with a grain.
const SIZES: [[usize; 4]; 2] = [[48, 48, 17, 1], [24, 16, 16, 20]];

/// Nodes that the ranks are judged by.
const JUDGED: usize = 2000;

/// Values of tables this near to the horizon are told from their neighbours.
const LEAST_COSINE: f64 = 0.06;

/// A node this far from all readings is a hole.
const HOLE: f64 = 0.1;

/// How data become a table.
///
/// ```
/// use glanz_measure::FactorOptions;
///
/// // A table with four ranks, smoothed by 64 neighbours.
/// let options = FactorOptions { ranks: Some(4), smooth: true, neighbours: Some(64), ..FactorOptions::default() };
/// assert_eq!((options.most_delta_e, FactorOptions::default().ranks), (0.3, None));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FactorOptions {
    /// How many ranks; as many as it takes for `most_delta_e` where nothing is said.
    pub ranks: Option<usize>,
    /// The ΔE00 from all channels that 95 of 100 nodes stay below.
    pub most_delta_e: f64,
    /// Whether tables are smoothed, as readings always are, rather than taken at their word.
    pub smooth: bool,
    /// How many readings stand for a direction between them; as many as tell readings best where nothing is said.
    pub neighbours: Option<usize>,
}

impl Default for FactorOptions {
    fn default() -> Self {
        Self { ranks: None, most_delta_e: 0.3, smooth: false, neighbours: None }
    }
}

/// Why data cannot be drawn.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FactorError {
    /// There are more ranks asked for than there can be.
    #[error("{asked} ranks of {channels} channels: there are 1 to {most}", most = FactorTable::MOST_RANKS.min(*channels))]
    Ranks {
        /// How many are asked for.
        asked: usize,
        /// How many channels there are.
        channels: usize,
    },
    /// No model can be fitted, of which the table would be a factor.
    #[error(transparent)]
    Fit(#[from] FitError),
}

/// What is to be known of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct FactorFacts {
    /// The ΔE00 from all channels that 95 of 100 nodes stay below, with 1, 2 … ranks.
    pub delta_e: Vec<f64>,
    /// The part of the nodes above the horizon that are far from all readings.
    pub holes: f64,
    /// How many readings the table is of.
    pub readings: usize,
    /// Bytes of the table.
    pub bytes: usize,
    /// The mean difference of the logarithms of readings from what their neighbours tell of them.
    pub noise: f64,
}

/// Measured reflectance as lobes under a table of factors.
///
/// ```
/// use glanz_math::Vec3;
/// use glanz_measure::{Channels, Data, FactorOptions, Factored, Format, Measured, Quantity, Readings};
///
/// // A matte red with a highlight that nobody knows, measured in a plane.
/// let mut readings = Readings::new(Channels::Rgb);
/// for (i, o) in (0..40).flat_map(|i| (0..40).map(move |o| (i, o))) {
///     let (theta_i, theta_o) = (f64::from(i) * 0.035, f64::from(o) * 0.07 - 1.4);
///     let wi = Vec3::from_angles(theta_i, std::f64::consts::PI);
///     let wo = Vec3::from_angles(theta_o.abs(), if theta_o < 0.0 { std::f64::consts::PI } else { 0.0 });
///     let gloss = (0.4 * (-30.0 * (theta_o - theta_i).powi(2)).exp()) as f32;
///     readings.push(wi, wo, &[0.2 + gloss, 0.05 + gloss, 0.03 + gloss]);
/// }
/// let measured = Measured {
///     format: Format::Csv,
///     quantity: Quantity::Brdf,
///     description: String::new(),
///     data: Data::Readings(readings),
///     notes: Vec::new(),
/// };
/// let factored = Factored::of(&measured, &FactorOptions::default())?;
/// let (wi, wo) = (Vec3::from_angles(0.5, std::f64::consts::PI), Vec3::from_angles(0.6, 0.0));
/// let exact = 0.2 + 0.4 * (-30.0_f64 * 0.01).exp();
/// assert!((factored.value(wi, wo)[0] - exact).abs() < 0.02 * exact);
/// # Ok::<(), glanz_measure::FactorError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Factored {
    channels: Positive,
    /// The fitted lobes, with a tint for each positive channel.
    lobes: Vec<(Shape, Vec<f64>)>,
    table: Arc<FactorTable>,
    /// For each rank what it counts for in each positive channel.
    mix: Vec<Vec<f64>>,
    azimuth: f64,
    /// What is to be known of it.
    pub facts: FactorFacts,
}

impl Factored {
    /// Data in this form.
    ///
    /// # Errors
    ///
    /// [`FactorError`] where no model can be fitted, and for more ranks than there can be.
    pub fn of(measured: &Measured, options: &FactorOptions) -> Result<Self, FactorError> {
        let readings = measured.readings();
        let channels = readings.channels().count();
        let most = FactorTable::MOST_RANKS.min(channels);
        if let Some(asked) = options.ranks.filter(|asked| !(1..=most).contains(asked)) {
            return Err(FactorError::Ranks { asked, channels });
        }
        let smoothed = Smoothed::of(measured, options.neighbours)?;
        Ok(Self::on_nodes(&smoothed, (!options.smooth).then_some(measured), options))
    }

    fn on_nodes(smoothed: &Smoothed, table: Option<&Measured>, options: &FactorOptions) -> Self {
        let (channels, carrier) = (smoothed.channels().count(), smoothed.carrier());
        let sizes = SIZES[usize::from(smoothed.is_anisotropic())];
        let nodes = FactorTable::nodes(sizes);
        let mut factors = Vec::with_capacity(nodes.len() * channels);
        let (mut above, mut far) = (0_usize, 0_usize);
        for [wo, wi] in &nodes {
            let exact = table.and_then(|measured| exact(measured, smoothed, *wi, *wo));
            let is_above = wi.z > 0.0 && wo.z > 0.0;
            above += usize::from(is_above);
            factors.extend(exact.unwrap_or_else(|| {
                let (told, nearest) = smoothed.factors(*wi, *wo);
                far += usize::from(is_above && nearest > HOLE);
                told
            }));
        }
        let counted = counted(&nodes, carrier);
        let judge = judge(smoothed.positive().positive(), &nodes, &counted, carrier, &factors);
        let weights = channel_weights(smoothed.positive().positive());
        let columns = Columns { channels, factors: &factors, nodes: counted, weights };
        let (Ranked { chosen, mix }, delta_e) = columns.ranked(options.ranks, options.most_delta_e, &judge);
        let values = factors.chunks(channels).flat_map(|node| chosen.iter().map(|c| node[*c] as f32));
        let table = FactorTable::new(sizes, chosen.len(), values.collect())
            .expect("as many factors as nodes times ranks, all of them finite exponentials or quotients");
        let facts = FactorFacts {
            delta_e,
            holes: far as f64 / above.max(1) as f64,
            readings: smoothed.readings(),
            bytes: table.bytes(),
            noise: smoothed.noise(),
        };
        let (table, channels) = (Arc::new(table), smoothed.positive().clone());
        let azimuth = smoothed.azimuth();
        Self { channels, lobes: carrier.lobes.clone(), table, mix, azimuth, facts }
    }

    /// What the tints' numbers belong to.
    pub fn channels(&self) -> &Channels {
        self.channels.own()
    }

    /// The table.
    pub fn table(&self) -> &Arc<FactorTable> {
        &self.table
    }

    /// The azimuth of the x axis of lobes and table in the frame of the data, in degrees, which is the `aniso_deg` of a
    /// material: that of an oblique grain. It is 0 where there is no grain, or it runs along an axis.
    pub fn aniso_deg(&self) -> f64 {
        self.azimuth.to_degrees()
    }

    /// All lobes: shape, the rank of the table that is a factor of it, and a tint for each channel, which may be negative.
    /// Those of one shape stand together.
    pub fn lobes(&self) -> Vec<(Shape, LayerWeight, Vec<f64>)> {
        let mut all = Vec::new();
        for (shape, tint) in &self.lobes {
            for (rank, mix) in self.mix.iter().enumerate() {
                let layer = LayerWeight::Table { table: Arc::clone(&self.table), rank };
                let tint = tint.iter().zip(mix).map(|(tint, mix)| tint * mix).collect();
                all.push((shape.clone(), layer, self.channels.from(tint)));
            }
        }
        all
    }

    /// The BRDF at a pair of directions above the horizon, in 1/sr, as it is drawn.
    pub fn value(&self, wi: Vec3<f64>, wo: Vec3<f64>) -> Vec<f64> {
        let pair = DirectionPair::new(turned(wo, -self.azimuth), turned(wi, -self.azimuth));
        let factors = self.table.factors(&pair);
        let mut values = vec![0.0; self.channels.own().count()];
        for (shape, tint) in &self.lobes {
            let value = shape.f_cos(&pair) / wi.z.max(1e-6);
            for (c, sum) in values.iter_mut().enumerate() {
                let mixed: f64 = self.mix.iter().zip(factors).map(|(mix, factor)| mix[c] * factor).sum();
                *sum += value * tint[c] * mixed;
            }
        }
        self.channels.from(values)
    }
}

/// A table's own value over the carrier, where it has one well above the horizon.
fn exact(measured: &Measured, smoothed: &Smoothed, wi: Vec3<f64>, wo: Vec3<f64>) -> Option<Vec<f64>> {
    if wi.z < LEAST_COSINE || wo.z < LEAST_COSINE {
        return None;
    }
    let own = |w: Vec3<f64>| turned(w, smoothed.azimuth());
    let values = smoothed.positive().to(measured.value(own(wi), own(wo))?);
    let over = |(value, carrier): (f64, f64)| (value.max(0.0) / carrier.max(1e-30)).min(1e3);
    Some(values.into_iter().zip(smoothed.carrier().values(wi, wo)).map(over).collect())
}

/// Nodes above the horizon, and how much they count: as much as cube roots of what is seen there.
fn counted(nodes: &[[Vec3<f64>; 2]], carrier: &Carrier) -> Vec<(usize, f64)> {
    let above = nodes.iter().enumerate().filter(|(_, [wo, wi])| wi.z > LEAST_COSINE && wo.z > LEAST_COSINE);
    let count = |(i, [wo, wi]): (usize, &[Vec3<f64>; 2])| {
        let values = carrier.values(*wi, *wo);
        (i, libm::cbrt(values.iter().sum::<f64>() / values.len().max(1) as f64))
    };
    above.map(count).collect()
}

fn judge(
    channels: &Channels,
    nodes: &[[Vec3<f64>; 2]],
    counted: &[(usize, f64)],
    carrier: &Carrier,
    factors: &[f64],
) -> Judge {
    let count = channels.count();
    let step = (counted.len() / JUDGED).max(1);
    let seen = counted.iter().step_by(step).map(|(node, _)| {
        let [wo, wi] = nodes[*node];
        let radiance = carrier.values(wi, wo).into_iter().map(|value| value * core::f64::consts::PI);
        (radiance.collect(), factors[node * count..][..count].to_vec())
    });
    Judge::new(channels, seen.collect())
}

/// How much channels count where ranks are chosen: wavelengths by what the eye sees of them.
fn channel_weights(channels: &Channels) -> Vec<f64> {
    let Channels::Wavelengths(nm) = channels else { return vec![1.0; channels.count()] };
    let observer = glanz_color::Observer::default();
    let seen = |nm: &f64| observer.channels.iter().map(|channel| channel.sensitivity.at(*nm)).sum::<f64>();
    nm.iter().map(|nm| seen(nm) + 0.01).collect()
}
