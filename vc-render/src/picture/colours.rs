//! Colour codings of depth, nodes and motion.

use vc_graph::portable::Portable;

use super::Picture;
use crate::frame::Frame;
use crate::modality::{NO_LABEL, NOTHING};

/// Colours that tell numbers apart: a number always has the same colour, which no other of the first eight
/// million numbers has. None is dark.
///
/// ```
/// use vc_render::picture::Palette;
/// assert_eq!(Palette.colour(7), Palette.colour(7));
/// assert_ne!(Palette.colour(7), Palette.colour(8));
/// ```
#[derive(Debug, Clone, Copy, Default)]
pub struct Palette;

/// Number of steps of a colour channel.
const STEPS: u64 = 200;

impl Palette {
    /// The colour of a number.
    ///
    /// It steps through all colours of at least 56 in each channel. With each step, the channels advance by
    /// about the powers of 0.819 of their range, so that a few consecutive numbers are spread evenly (Roberts'
    /// R3 sequence, 2018); the step has no common divisor with the number of colours, so none occurs twice.
    pub fn colour(self, number: u32) -> [u8; 3] {
        const STEP: u64 = 163 * STEPS * STEPS + 134 * STEPS + 109;
        let place = (u64::from(number) * STEP + STEP / 3) % (STEPS * STEPS * STEPS);
        [place / (STEPS * STEPS), place / STEPS % STEPS, place % STEPS].map(|step| 56 + step as u8)
    }
}

fn hsv(hue: f32, saturation: f32, value: f32) -> [u8; 3] {
    let part = |shift: f32| {
        let k = (shift + hue * 6.0) % 6.0;
        value - value * saturation * k.min(4.0 - k).clamp(0.0, 1.0)
    };
    [part(5.0), part(3.0), part(1.0)].map(|v| (v * 255.0 + 0.5) as u8)
}

fn picture(frame: &Frame, pixels: Vec<[u8; 3]>) -> Picture {
    let wanted = frame.width * frame.height;
    let pixels = if pixels.len() == wanted { pixels } else { vec![[0; 3]; wanted] };
    Picture { width: frame.width, height: frame.height, pixels }
}

/// A copy of the frame's colours; black if the frame has none.
pub fn rgb(frame: &Frame) -> Picture {
    picture(frame, frame.rgb.clone())
}

/// Depth: red nearby, over yellow, green and blue to nearly black at `farthest` metres and beyond, in Google's
/// Turbo colour map (Mikhailov 2019). Black if the frame has no depth.
///
/// ```
/// use vc_render::{Frame, picture};
/// let mut frame = Frame::new();
/// (frame.width, frame.height) = (3, 1);
/// frame.depth = vec![1.0, 7.0, f32::INFINITY];
/// let [near, far, nothing] = picture::depth(&frame, 8.0).pixels[..] else { unreachable!() };
/// assert!(near[0] > near[2] && far[2] > far[0]);
/// assert!(nothing.iter().all(|part| *part < 40));
/// ```
pub fn depth(frame: &Frame, farthest: f32) -> Picture {
    let colour = |&d: &f32| turbo(1.0 - (d / farthest).min(1.0));
    picture(frame, frame.depth.iter().map(colour).collect())
}

/// Google's Turbo colour map, as the polynomial of its authors (Mikhailov 2019).
fn turbo(x: f32) -> [u8; 3] {
    let powers = [1.0, x, x * x, x * x * x, x * x * x * x, x * x * x * x * x];
    let rows = [
        [0.135_721_4, 4.615_392_6, -42.660_32, 132.131_08, -152.942_4, 59.286_38],
        [0.091_402_61, 2.194_188_4, 4.842_967, -14.185_034, 4.277_298_6, 2.829_566],
        [0.106_673_3, 12.641_946, -60.582_05, 110.362_77, -89.903_11, 27.348_25],
    ];
    rows.map(|row| {
        let value: f32 = row.iter().zip(powers).map(|(a, b)| a * b).sum();
        (value.clamp(0.0, 1.0) * 255.0 + 0.5) as u8
    })
}

/// Nodes in the palette's colours, black where nothing is visible; black if the frame has no nodes.
///
/// ```
/// use vc_graph::NodeId;
/// use vc_render::picture::{self, Palette};
/// use vc_render::{Frame, NOTHING};
/// let mut frame = Frame::new();
/// (frame.width, frame.height) = (2, 1);
/// frame.instance = vec![NodeId(5), NOTHING];
/// assert_eq!(picture::instances(&frame).pixels, [Palette.colour(5), [0; 3]]);
/// ```
pub fn instances(frame: &Frame) -> Picture {
    let colour = |n: &vc_graph::NodeId| if *n == NOTHING { [0; 3] } else { Palette.colour(n.0) };
    picture(frame, frame.instance.iter().map(colour).collect())
}

/// Parts in the palette's colours, distinct for each node, black where nothing is visible; needs nodes and
/// parts.
pub fn parts(frame: &Frame) -> Picture {
    // Beyond this number of parts, nodes share colours with the next.
    const MOST: u32 = 64;
    let colour = |(node, part): (&vc_graph::NodeId, &u16)| {
        if *node == NOTHING { [0; 3] } else { Palette.colour(node.0.wrapping_mul(MOST).wrapping_add(u32::from(*part))) }
    };
    picture(frame, frame.instance.iter().zip(&frame.part).map(colour).collect())
}

/// Classes in the palette's colours, black where nothing is visible; black if the frame has no classes.
///
/// ```
/// use vc_render::picture::{self, Palette};
/// use vc_render::{Frame, NO_LABEL};
/// let mut frame = Frame::new();
/// (frame.width, frame.height) = (2, 1);
/// frame.class = vec![5, NO_LABEL];
/// assert_eq!(picture::classes(&frame).pixels, [Palette.colour(5), [0; 3]]);
/// ```
pub fn classes(frame: &Frame) -> Picture {
    let colour = |c: &u16| if *c == NO_LABEL { [0; 3] } else { Palette.colour(u32::from(*c)) };
    picture(frame, frame.class.iter().map(colour).collect())
}

/// Normals: X, Y and Z of the world as red, green and blue, from -1 to 1; grey where nothing is visible.
///
/// ```
/// use vc_render::{Frame, picture};
/// let mut frame = Frame::new();
/// (frame.width, frame.height) = (2, 1);
/// frame.normal = vec![[0.0, 0.0, 1.0], [0.0; 3]];
/// assert_eq!(picture::normals(&frame).pixels, [[127, 127, 255], [127; 3]]);
/// ```
pub fn normals(frame: &Frame) -> Picture {
    picture(frame, frame.normal.iter().map(|n| n.map(|v| (127.5 + 127.5 * v) as u8)).collect())
}

/// Motion to the next moment: direction as hue (red is to the right), length up to `most` pixels as saturation;
/// white where nothing moves, black where nothing is visible.
///
/// ```
/// use vc_render::{Frame, picture};
/// let mut frame = Frame::new();
/// (frame.width, frame.height) = (3, 1);
/// frame.flow_forward = vec![[0.0, 0.0], [4.0, 0.0], [f32::NAN; 2]];
/// assert_eq!(picture::flow(&frame, 4.0).pixels, [[255; 3], [255, 0, 0], [0; 3]]);
/// ```
pub fn flow(frame: &Frame, most: f32) -> Picture {
    let colour = |&[x, y]: &[f32; 2]| {
        if x.is_nan() {
            return [0; 3];
        }
        let hue = y.angle_to(x) / std::f32::consts::TAU;
        hsv(if hue < 0.0 { hue + 1.0 } else { hue }, (x.hypotenuse(y) / most).min(1.0), 1.0)
    };
    picture(frame, frame.flow_forward.iter().map(colour).collect())
}

/// The visible masks in the colours of their nodes, mixed half and half with the frame's colours in grey.
/// Linear in the pixels of the picture and of all boxes. The module's page has an example.
pub fn masks(frame: &Frame) -> Picture {
    let mut all = picture(frame, frame.rgb.clone());
    for p in &mut all.pixels {
        *p = [(p.iter().map(|v| u16::from(*v)).sum::<u16>() / 3) as u8; 3];
    }
    for mask in frame.masks() {
        let (colour, within) = (Palette.colour(mask.node().0), mask.within());
        for y in within.y..within.y + within.height {
            for x in (within.x..within.x + within.width).filter(|x| mask.has(*x, y)) {
                let p = &mut all.pixels[y as usize * frame.width + x as usize];
                *p = [0, 1, 2].map(|i: usize| (u16::midpoint(u16::from(p[i]), u16::from(colour[i]))) as u8);
            }
        }
    }
    all
}

/// Draws bounding boxes over a picture: visible ones as rectangles, oriented ones as edges in space, for
/// objects with at least `least` visible pixels. Linear in the pixels of the lines. The module's page has an
/// example.
pub fn with_boxes(mut picture: Picture, frame: &Frame, least: u32) -> Picture {
    for label in frame.boxes.iter().filter(|b| b.area >= least) {
        let colour = Palette.colour(label.node.0);
        picture.outline(&label.visible, colour);
        for (from, axis) in (0..8).flat_map(|c| (0..3).map(move |a| (c, a))).filter(|(c, a)| c >> a & 1 == 0) {
            let ends = [label.oriented.corners[from], label.oriented.corners[from | 1 << axis]];
            if let [Some(from), Some(to)] = ends {
                picture.line([from.x, from.y], [to.x, to.y], colour.map(|v| v / 2 + 100));
            }
        }
    }
    picture
}
