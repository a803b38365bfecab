//! The seam between what is drawn and what draws it.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use glanz_picture::{ChannelError, Develop, Frame, develop};

use crate::cpu::Renderer;
use crate::{DrawOptions, Prepared, View};

/// How much of a frame is drawn, for those who watch another thread draw it.
///
/// ```
/// use glanz_render::Shot;
/// use glanz_scene::Scene;
///
/// let mut shot = Shot::new(&Scene::new().with_size(40, 40))?;
/// let meter = shot.meter().expect("the CPU tells it");
/// assert_eq!(meter.part(), 0.0);
/// shot.rgba8()?;
/// assert_eq!(meter.part(), 1.0);
/// # Ok::<(), glanz_render::ShotError>(())
/// ```
#[derive(Debug, Default)]
pub struct DrawMeter {
    done: AtomicUsize,
    all: AtomicUsize,
}

impl DrawMeter {
    /// From 0 to 1; 0 before the first frame.
    pub fn part(&self) -> f64 {
        let [done, all] = [&self.done, &self.all].map(|count| count.load(Ordering::Relaxed));
        if all == 0 { 0.0 } else { (done as f64 / all as f64).min(1.0) }
    }

    /// A frame of so many pieces begins.
    pub(crate) fn begin(&self, pieces: usize) {
        self.done.store(0, Ordering::Relaxed);
        self.all.store(pieces, Ordering::Relaxed);
    }

    /// A piece of it is drawn.
    pub(crate) fn step(&self) {
        self.done.fetch_add(1, Ordering::Relaxed);
    }
}

/// Why a back end drew no frame.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum BackendError {
    /// A program does not come to its end.
    #[error(transparent)]
    Run(#[from] glanz_shader::RunError),
    /// The back end does not draw this, or its device failed.
    #[error("{what}")]
    Device {
        /// What, and what would be right.
        what: String,
    },
}

/// Whatever turns prepared arrays and a view into a frame: the CPU's rasteriser, or a program's own.
///
/// A back end reads [`Prepared`] and what [`crate::view`] makes of it for one camera; it never sees the scene. All
/// back ends are compared with the CPU's narrowest path.
///
/// ```
/// use glanz_render::{Backend, DrawOptions, Frame, Prepared, Shot, View, cpu::Renderer};
/// use glanz_scene::Scene;
///
/// /// Counts frames, and lets the CPU draw.
/// struct Counting(Renderer, usize);
///
/// impl Backend for Counting {
///     fn draw(&mut self, prepared: &Prepared, view: &View, options: &DrawOptions) -> Frame {
///         self.1 += 1;
///         self.0.draw(prepared, view, options)
///     }
/// }
///
/// let scene = Scene::new().with_size(8, 8);
/// let counting = Box::new(Counting(Renderer::new(), 0));
/// assert_eq!(Shot::new(&scene)?.on(counting).rgba8()?, Shot::new(&scene)?.rgba8()?);
/// # Ok::<(), glanz_render::ShotError>(())
/// ```
pub trait Backend: Send {
    /// Draws into a frame of linear channels, three of them.
    fn draw(&mut self, prepared: &Prepared, view: &View, options: &DrawOptions) -> Frame;

    /// The same into a frame that was drawn before, whose memory is used again; all that it held is replaced. To get
    /// fresh memory for a large frame takes as long as to draw it.
    fn draw_into(&mut self, prepared: &Prepared, view: &View, options: &DrawOptions, frame: &mut Frame) {
        *frame = self.draw(prepared, view, options);
    }

    /// Why the last frame is of no use, if it is not: a program did not come to its end, or the device failed. Asked once.
    fn take_error(&mut self) -> Option<BackendError> {
        None
    }

    /// How much of a frame is drawn while it is drawn, where the back end knows.
    fn meter(&self) -> Option<Arc<DrawMeter>> {
        None
    }

    /// Draws and develops into 8-bit RGBA: `4·width·height` bytes, rows from the top. The result is that of
    /// [`Backend::draw`] followed by [`develop()`]; a back end may do both at once.
    ///
    /// # Errors
    /// If the channels are not what the settings of development are for.
    ///
    /// # Panics
    /// If `out` has another length.
    fn draw_rgba8(
        &mut self,
        prepared: &Prepared,
        view: &View,
        options: &DrawOptions,
        settings: &Develop,
        out: &mut [u8],
    ) -> Result<(), ChannelError> {
        out.copy_from_slice(&develop(&self.draw(prepared, view, options), settings)?);
        Ok(())
    }
}

/// The back end that draws where none is chosen: the CPU's, with the machine's best instructions.
pub fn default_backend() -> Box<dyn Backend> {
    Box::new(Renderer::new())
}

/// Draws into a frame of linear channels by the [default back end](default_backend). Runs in the current rayon pool.
pub fn draw(prepared: &Prepared, view: &View, options: &DrawOptions) -> Frame {
    default_backend().draw(prepared, view, options)
}

/// Draws and develops by the [default back end](default_backend); see [`Backend::draw_rgba8`].
///
/// # Errors
/// If the channels are not what the settings of development are for.
///
/// # Panics
/// If `out` has another length.
pub fn draw_rgba8(
    prepared: &Prepared,
    view: &View,
    options: &DrawOptions,
    settings: &Develop,
    out: &mut [u8],
) -> Result<(), ChannelError> {
    default_backend().draw_rgba8(prepared, view, options, settings, out)
}
