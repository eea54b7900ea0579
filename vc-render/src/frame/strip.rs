//! Strips: some rows of a frame's buffers.

use std::ops::Range;

use vc_graph::NodeId;

use super::Frame;

macro_rules! strips {
    ($($name:ident: $of:ty),* $(,)?) => {
        /// Rows of all buffers of a frame; buffers of modalities not requested are empty.
        pub(crate) struct Strip<'a> {
            pub(crate) width: usize,
            pub(crate) rows: Range<i32>,
            $(pub(crate) $name: &'a mut [$of],)*
        }

        impl<'a> Strip<'a> {
            /// All rows of a frame.
            pub(crate) fn whole(frame: &'a mut Frame) -> Self {
                let Frame { width, height, $($name,)* .. } = frame;
                Self { width: *width, rows: 0..*height as i32, $($name,)* }
            }

            /// Splits off the first rows.
            pub(crate) fn split(self, rows: i32) -> (Self, Self) {
                let (start, end) = (self.rows.start, self.rows.end);
                let count = rows as usize * self.width;
                $(let $name = self.$name.split_at_mut(count.min(self.$name.len()));)*
                (
                    Self { width: self.width, rows: start..start + rows, $($name: $name.0,)* },
                    Self { width: self.width, rows: start + rows..end, $($name: $name.1,)* },
                )
            }
        }
    };
}

strips! {
    rgb: [u8; 3],
    depth: f32,
    distance: f32,
    instance: NodeId,
    part: u16,
    class: u16,
    normal: [f32; 3],
    position: [f32; 3],
    flow_forward: [f32; 2],
    flow_backward: [f32; 2],
    occluded_forward: u8,
    occluded_backward: u8,
}

impl Strip<'_> {
    /// Range of an image row's pixels in the strip's buffers.
    #[inline(always)]
    pub(crate) fn row(&self, y: i32) -> Range<usize> {
        let at = (y - self.rows.start) as usize * self.width;
        at..at + self.width
    }
}
