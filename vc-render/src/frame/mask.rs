//! Masks: the pixels of each object.

use vc_graph::NodeId;

use super::PixelBox;

/// Masks of many objects in one block of memory.
#[derive(Default, Clone)]
pub(crate) struct Masks {
    entries: Vec<Entry>,
    bits: Vec<u64>,
    width: usize,
    height: usize,
}

#[derive(Clone)]
struct Entry {
    node: NodeId,
    within: PixelBox,
    first: usize,
    words: usize,
}

impl Masks {
    pub(crate) fn clear(&mut self) {
        self.entries.clear();
        self.bits.clear();
    }

    pub(crate) fn begin(&mut self, width: usize, height: usize) {
        self.clear();
        (self.width, self.height) = (width, height);
    }

    /// Adds an empty mask for a box within the image.
    pub(crate) fn push(&mut self, node: NodeId, within: PixelBox) {
        let words = (within.width as usize).div_ceil(64);
        self.entries.push(Entry { node, within, first: self.bits.len(), words });
        self.bits.resize(self.bits.len() + words * within.height as usize, 0);
    }

    /// Sets the pixels `from..to` of a row in a mask.
    #[inline]
    pub(crate) fn set(&mut self, mask: usize, y: i32, from: i32, to: i32) {
        let Entry { within, first, words, .. } = self.entries[mask];
        let at = first + (y - within.y) as usize * words;
        let (from, to) = ((from - within.x) as usize, (to - within.x) as usize);
        for word in from / 64..to.div_ceil(64) {
            let low = from.saturating_sub(word * 64);
            let high = (to - word * 64).min(64);
            self.bits[at + word] |= (u64::MAX >> (64 - (high - low))) << low;
        }
    }

    pub(crate) fn iter(&self) -> impl ExactSizeIterator<Item = Mask<'_>> {
        self.entries.iter().map(|entry| Mask { entry, masks: self })
    }
}

/// The pixels of one object, from [`Frame::masks`](crate::Frame::masks) or
/// [`Frame::amodal_masks`](crate::Frame::amodal_masks).
///
/// ```
/// # use nalgebra::{Point3, Vector3};
/// # use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
/// use vc_render::{Camera, Frame, Modality, Renderer, Shot};
/// # let mut scene = SceneBuilder::new("flat");
/// # let kitchen = scene.add(Draft::new("kitchen"))?;
/// # let size = Bounds::standing(Vector3::new(0.6, 0.6, 1.8));
/// # let fridge = scene.add_in(kitchen, Draft::new("fridge").at(Pose::translation(2.0, 0.0, 0.0)).bounds(size))?;
/// # let scene = scene.build();
/// # let mut renderer = Renderer::new();
/// # let snapshot = renderer.snapshot(&scene)?;
/// # let camera = Camera::with_fov(64, 48, 1.0).looking(Point3::new(0.0, 0.0, 1.0), Point3::new(2.0, 0.0, 1.0));
/// let mut frame = Frame::new();
/// renderer.render(&Shot::new(&snapshot, &camera, Modality::Masks), &mut frame)?;
/// let mask = frame.masks().next().ok_or("nothing is seen")?;
/// assert_eq!((mask.node(), mask.area()), (fridge, 16 * 45));
/// assert!(mask.has(24, 3) && !mask.has(23, 3));
/// // Rows start at the top, as in all buffers.
/// assert_eq!(mask.bitmap()[24 * 64 + 32], 1);
/// // Runs go down the columns, starting at the left.
/// assert_eq!(mask.rle().counts[..3], [24 * 48 + 3, 45, 3]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy)]
pub struct Mask<'a> {
    entry: &'a Entry,
    masks: &'a Masks,
}

impl Mask<'_> {
    /// The node whose pixels these are.
    pub fn node(&self) -> NodeId {
        self.entry.node
    }

    /// The box around it, within the image.
    pub fn within(&self) -> PixelBox {
        self.entry.within
    }

    /// Whether a pixel of the image is in the mask; false outside the image. Costs a look at one word.
    pub fn has(&self, x: i32, y: i32) -> bool {
        let PixelBox { x: left, y: top, width, height } = self.entry.within;
        let (x, y) = (x - left, y - top);
        if !(0..width).contains(&x) || !(0..height).contains(&y) {
            return false;
        }
        let word = self.entry.first + y as usize * self.entry.words + x as usize / 64;
        self.masks.bits[word] >> (x % 64) & 1 == 1
    }

    /// Number of pixels in the mask. Costs one step for 64 pixels of each row of [`within`](Self::within).
    pub fn area(&self) -> u32 {
        let words = self.entry.words * self.entry.within.height as usize;
        self.masks.bits[self.entry.first..self.entry.first + words].iter().map(|w| w.count_ones()).sum()
    }

    /// The mask as one byte for each pixel of the image, 1 inside and 0 outside: `height * width` bytes,
    /// row-major, rows from the top. Costs a step for every pixel of the image, even if the object is small.
    pub fn bitmap(&self) -> Vec<u8> {
        let (width, height) = (self.masks.width as i32, self.masks.height as i32);
        (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(|(x, y)| u8::from(self.has(x, y))).collect()
    }

    /// The mask in COCO's run-length encoding: lengths of runs down the columns, from the left, alternately of
    /// pixels outside and inside. Costs a step for every pixel of [`within`](Self::within), and takes four
    /// bytes for each run.
    ///
    /// ```
    /// # use nalgebra::{Point3, Vector3};
    /// # use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
    /// # let mut scene = SceneBuilder::new("flat");
    /// # let kitchen = scene.add(Draft::new("kitchen"))?;
    /// # let size = Bounds::standing(Vector3::new(0.6, 0.6, 1.8));
    /// # let fridge = scene.add_in(kitchen, Draft::new("fridge").at(Pose::translation(2.0, 0.0, 0.0)).bounds(size))?;
    /// # let scene = scene.build();
    /// use vc_render::{Camera, Frame, Modality, Renderer, Shot};
    /// # let mut renderer = Renderer::new();
    /// # let snapshot = renderer.snapshot(&scene)?;
    /// # let camera = Camera::with_fov(64, 48, 1.0).looking(Point3::new(0.0, 0.0, 1.0), Point3::new(2.0, 0.0, 1.0));
    /// let mut frame = Frame::new();
    /// renderer.render(&Shot::new(&snapshot, &camera, Modality::Masks), &mut frame)?;
    /// let mask = frame.masks().next().ok_or("nothing is visible")?;
    /// assert_eq!(mask.node(), fridge);
    /// assert_eq!(mask.rle().area(), mask.area());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn rle(&self) -> Rle {
        let within = self.entry.within;
        let (height, total) = (self.masks.height as u32, (self.masks.width * self.masks.height) as u32);
        let (mut counts, mut end, mut start) = (Vec::new(), 0, None);
        for x in within.x..within.x + within.width {
            for y in within.y..within.y + within.height {
                let at = x as u32 * height + y as u32;
                match (self.has(x, y), start) {
                    (true, None) => start = Some(at),
                    (false, Some(first)) => {
                        counts.extend([first - end, at - first]);
                        (end, start) = (at, None);
                    }
                    (true, Some(_)) | (false, None) => {}
                }
            }
            // Between columns of the box are pixels outside it, unless it is as high as the image.
            let last = x as u32 * height + (within.y + within.height) as u32;
            if let Some(first) = start.take_if(|_| within.height as u32 != height) {
                counts.extend([first - end, last - first]);
                end = last;
            }
        }
        let bottom = (within.x + within.width) as u32 * height;
        if let Some(first) = start {
            counts.extend([first - end, bottom - first]);
            end = bottom;
        }
        if end < total {
            counts.push(total - end);
        }
        Rle { size: [height, self.masks.width as u32], counts }
    }
}

/// A mask in run-length encoding, column by column.
///
/// ```
/// use vc_render::Rle;
/// // A square of two by two in the middle of four by four pixels.
/// let square = Rle { size: [4, 4], counts: vec![5, 2, 2, 2, 5] };
/// assert_eq!(square.area(), 4);
/// assert_eq!(square.compressed(), "52203");
/// ```
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize)]
pub struct Rle {
    /// Height and width of the image, pixels.
    pub size: [u32; 2],
    /// Lengths of runs, alternately of pixels outside and inside, outside first.
    pub counts: Vec<u32>,
}

impl Rle {
    /// Number of pixels in the mask. Costs a step for each run.
    pub fn area(&self) -> u32 {
        self.counts.iter().skip(1).step_by(2).sum()
    }

    /// The counts in COCO's compressed text: each is written as the difference to the count before the last,
    /// five bits to a character (pycocotools' `rleToString`). Linear in the runs, mostly one or two characters
    /// each.
    pub fn compressed(&self) -> String {
        let mut text = String::new();
        for (i, &count) in self.counts.iter().enumerate() {
            let before = if i > 2 { i64::from(self.counts[i - 2]) } else { 0 };
            let mut left = i64::from(count) - before;
            loop {
                let bits = left & 0x1f;
                left >>= 5;
                let more = if bits & 0x10 == 0 { left != 0 } else { left != -1 };
                let code = bits as u8 | if more { 0x20 } else { 0 };
                text.push(char::from(code + 48));
                if !more {
                    break;
                }
            }
        }
        text
    }
}
