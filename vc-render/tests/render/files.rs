//! Files are read back by independent readers of their formats.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::{Stage, cameras, furnished};
use vc_render::format::{Coco, exr, npy, ply};
use vc_render::{Camera, Frame, Modalities, Modality, RenderError, Renderer, Rle, Shot, Snapshot};

fn rendered(wanted: impl Into<Modalities>) -> (Snapshot, Frame) {
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&furnished()).unwrap();
    let camera = cameras(90, 70)[0];
    let later = vc_render::Camera { pose: camera.pose * vc_graph::Pose::translation(0.02, 0.0, 0.05), ..camera };
    let mut frame = Frame::new();
    renderer.render(&Shot::new(&snapshot, &camera, wanted).after(&snapshot, &later), &mut frame).unwrap();
    (snapshot, frame)
}

/// Decodes runs down the columns into a picture in rows.
fn unrolled(size: [u32; 2], counts: &[u32]) -> Vec<u8> {
    let columns: Vec<u8> =
        counts.iter().enumerate().flat_map(|(i, n)| std::iter::repeat_n((i % 2) as u8, *n as usize)).collect();
    let [height, width] = size.map(|v| v as usize);
    assert_eq!(columns.len(), width * height);
    (0..width * height).map(|i| columns[i % width * height + i / width]).collect()
}

/// Decodes the counts in COCO's text: five bits a character, lowest first; a sixth bit marks that more follow,
/// and the highest bit of the last character is the sign. From the fourth count on, each is a difference to the
/// count before the last.
fn counts(text: &str) -> Vec<u32> {
    let (mut counts, mut value, mut shift) = (Vec::<i64>::new(), 0_i64, 0);
    for byte in text.bytes() {
        let bits = i64::from(byte) - 48;
        value |= (bits & 31) << shift;
        shift += 5;
        if bits & 32 == 0 {
            if bits & 16 != 0 {
                value -= 1 << shift;
            }
            let before = if counts.len() > 2 { counts[counts.len() - 2] } else { 0 };
            counts.push(value + before);
            (value, shift) = (0, 0);
        }
    }
    counts.into_iter().map(|v| u32::try_from(v).unwrap()).collect()
}

#[test]
fn run_lengths_are_read_back() {
    let (_, frame) = rendered(Modality::Instance | Modality::Boxes | Modality::Masks | Modality::Amodal);
    assert!(frame.masks().len() > 20);
    for mask in frame.masks().chain(frame.amodal_masks()) {
        let rle = mask.rle();
        assert_eq!(rle.size, [70, 90]);
        assert_eq!(unrolled(rle.size, &rle.counts), mask.bitmap(), "{}", mask.node());
        assert_eq!(counts(&rle.compressed()), rle.counts);
        // Only the first run may be empty.
        assert!(rle.counts[1..].iter().all(|n| *n > 0));
    }
    // The first and the last pixel, an empty mask, a full one, and long runs.
    for list in [vec![0, 1, 98, 1], vec![100], vec![0, 100], vec![99_999, 3, 1, 1_000_000, 5, 6, 7]] {
        let rle = Rle { size: [10, 10], counts: list.clone() };
        assert_eq!(counts(&rle.compressed()), list);
    }
    // A square in the middle of 4 by 4 pixels, encoded by hand.
    assert_eq!(Rle { size: [4, 4], counts: vec![5, 2, 2, 2, 5] }.compressed(), "52203");
}

#[test]
fn coco_documents_are_read_back() {
    let (snapshot, frame) = rendered(Modality::Instance | Modality::Boxes | Modality::Masks);
    let mut coco = Coco::default();
    ["a.png", "b.png"].into_iter().for_each(|name| coco.add(name, &frame, &snapshot).unwrap());
    let document: serde_json::Value = serde_json::from_str(&coco.document().unwrap()).unwrap();
    let list = |name: &str| document[name].as_array().unwrap();
    assert_eq!(list("images").len(), 2);
    assert_eq!(list("images")[1]["file_name"], "b.png");
    assert_eq!((&list("images")[0]["width"], &list("images")[0]["height"]), (&90.into(), &70.into()));
    assert_eq!(list("annotations").len(), 2 * frame.boxes.len());
    let number = |v: &serde_json::Value| v.as_i64().unwrap();
    let names: std::collections::BTreeMap<i64, &str> =
        list("categories").iter().map(|c| (number(&c["id"]), c["name"].as_str().unwrap())).collect();
    for (i, one) in list("annotations").iter().enumerate() {
        let (label, mask) = (&frame.boxes[i % frame.boxes.len()], frame.masks().nth(i % frame.boxes.len()).unwrap());
        assert_eq!(number(&one["id"]), i as i64 + 1);
        assert_eq!(number(&one["image_id"]), if i < frame.boxes.len() { 1 } else { 2 });
        assert_eq!(names[&number(&one["category_id"])], &**snapshot.class(label.class).unwrap());
        let runs = counts(one["segmentation"]["counts"].as_str().unwrap());
        let bits = unrolled([70, 90], &runs);
        assert_eq!(bits, mask.bitmap());
        assert_eq!(number(&one["area"]), bits.iter().map(|b| i64::from(*b)).sum::<i64>());
        // The box computed from the pixels themselves.
        let set: Vec<usize> = (0..bits.len()).filter(|i| bits[*i] == 1).collect();
        let ends = |of: fn(usize) -> usize| {
            let (low, high) = (set.iter().map(|i| of(*i)).min().unwrap(), set.iter().map(|i| of(*i)).max().unwrap());
            (low as i64, (high - low + 1) as i64)
        };
        let ((x, width), (y, height)) = (ends(|i| i % 90), ends(|i| i / 90));
        let bbox: Vec<i64> = one["bbox"].as_array().unwrap().iter().map(number).collect();
        assert_eq!(bbox, [x, y, width, height]);
    }
    let (_, bare) = rendered(Modality::Masks);
    assert!(Coco::default().add("a.png", &bare, &snapshot).is_err());
}

#[test]
fn frames_without_boxes_or_masks_are_refused_and_empty_pictures_are_not() {
    let mut coco = Coco::default();
    let both = Modality::Boxes | Modality::Masks;
    for wanted in [Modality::Depth.into(), Modality::Boxes.into(), Modality::Masks.into(), Modalities::NONE] {
        let (snapshot, frame) = rendered(wanted);
        let refused = coco.add("a.png", &frame, &snapshot);
        assert!(matches!(refused, Err(RenderError::Missing { wanted: "COCO", .. })), "{wanted:?}: {refused:?}");
        assert_eq!(coco.pictures(), 0, "{wanted:?}");
    }
    // A picture in which nothing is visible still counts as a picture.
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&Stage::new().build()).unwrap();
    assert!(coco.add("a.png", &Frame::new(), &snapshot).is_err(), "a frame that was never rendered into");
    let mut frame = Frame::new();
    renderer.render(&Shot::new(&snapshot, &Camera::with_fov(9, 7, 1.0), both), &mut frame).unwrap();
    coco.add("b.png", &frame, &snapshot).unwrap();
    assert_eq!(coco.pictures(), 1);
    let document: serde_json::Value = serde_json::from_str(&coco.document().unwrap()).unwrap();
    assert_eq!(document["images"].as_array().map(Vec::len), Some(1));
    assert_eq!((&document["images"][0]["file_name"], &document["images"][0]["id"]), (&"b.png".into(), &1.into()));
    assert_eq!(document["annotations"].as_array().map(Vec::len), Some(0));
}

/// A cube of some class, some metres ahead.
fn seen(class: &str) -> (Snapshot, Frame) {
    let mut scene = vc_graph::SceneBuilder::new("one");
    let cube = vc_graph::Bounds::standing([0.5; 3].into());
    scene.add(vc_graph::Draft::new(class).at(vc_graph::Pose::translation(2.0, 0.0, 0.0)).bounds(cube)).unwrap();
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&scene.build()).unwrap();
    let (mut frame, camera) = (Frame::new(), Camera::with_fov(24, 18, 1.0));
    renderer.render(&Shot::new(&snapshot, &camera, Modality::Boxes | Modality::Masks), &mut frame).unwrap();
    (snapshot, frame)
}

#[test]
fn one_document_is_of_many_scenes() {
    let mut coco = Coco::default();
    // The class table has one of these classes; the others have the same number in their scenes.
    for (name, class) in [("a", "florbel"), ("b", "grumkin"), ("c", "sofa"), ("d", "grumkin"), ("e", "florbel")] {
        let (snapshot, frame) = seen(class);
        coco.add(format!("{name}.png"), &frame, &snapshot).unwrap();
    }
    let document: serde_json::Value = serde_json::from_str(&coco.document().unwrap()).unwrap();
    let ids = |list: &str, key: &str| -> Vec<i64> {
        document[list].as_array().unwrap().iter().map(|one| one[key].as_i64().unwrap()).collect()
    };
    assert_eq!((ids("images", "id"), ids("annotations", "id")), (vec![1, 2, 3, 4, 5], vec![1, 2, 3, 4, 5]));
    let category = |id: i64| document["categories"].as_array().unwrap().iter().find(|c| c["id"] == id).unwrap();
    let names: Vec<&str> =
        ids("annotations", "category_id").into_iter().map(|id| category(id)["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["florbel", "grumkin", "sofa", "grumkin", "florbel"]);
    let mut numbers = ids("categories", "id");
    numbers.dedup();
    assert_eq!(numbers.len(), 3);
    assert_eq!(category(ids("annotations", "category_id")[2])["supercategory"], "furniture");
    assert!(document["info"]["version"].is_string() && document["licenses"].is_array());
}

/// Reads an array by NumPy's description of the format: magic, version, length of the header, header, numbers.
fn array(file: &[u8]) -> (String, Vec<usize>, &[u8]) {
    assert_eq!(file[..8], *b"\x93NUMPY\x01\x00");
    let length = usize::from(u16::from_le_bytes([file[8], file[9]]));
    assert_eq!((10 + length) % 64, 0);
    let header = std::str::from_utf8(&file[10..10 + length]).unwrap();
    assert!(header.ends_with('\n') && header.contains("'fortran_order': False"));
    let after = |key: &str| header.split(key).nth(1).unwrap();
    let kind = after("'descr': '").split('\'').next().unwrap().to_owned();
    let shape = after("'shape': (").split(')').next().unwrap();
    let shape = shape.split(',').filter(|n| !n.trim().is_empty()).map(|n| n.trim().parse().unwrap()).collect();
    (kind, shape, &file[10 + length..])
}

fn floats(bytes: &[u8]) -> Vec<f32> {
    bytes.as_chunks::<4>().0.iter().map(|b| f32::from_le_bytes(*b)).collect()
}

fn same(a: &[f32], b: &[f32]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.to_bits() == b.to_bits())
}

#[test]
fn numpy_arrays_are_read_back() {
    let (_, mut frame) = rendered(Modality::Depth | Modality::FlowForward | Modality::Class);
    (frame.depth[3], frame.depth[4]) = (f32::INFINITY, f32::NAN);
    let file = npy(&frame.depth, &[70, 90]).unwrap();
    let (kind, shape, bytes) = array(&file);
    assert_eq!((kind.as_str(), shape.as_slice()), ("<f4", [70, 90].as_slice()));
    assert!(same(&floats(bytes), &frame.depth));
    let file = npy(frame.flow_forward.as_flattened(), &[70, 90, 2]).unwrap();
    let (_, shape, bytes) = array(&file);
    assert_eq!(shape, [70, 90, 2]);
    assert!(same(&floats(bytes), frame.flow_forward.as_flattened()));
    let file = npy(&frame.class, &[6300]).unwrap();
    let (kind, shape, bytes) = array(&file);
    assert_eq!((kind.as_str(), shape.as_slice()), ("<u2", [6300].as_slice()));
    assert!(bytes.as_chunks::<2>().0.iter().map(|b| u16::from_le_bytes(*b)).eq(frame.class.iter().copied()));
    assert_eq!(array(&npy(&[1_u8, 2, 3], &[3, 1]).unwrap()).2, [1, 2, 3]);
}

/// A reader of OpenEXR's uncompressed scan lines: attributes by name, and channels by name.
struct Exr {
    attributes: std::collections::BTreeMap<String, (String, Vec<u8>)>,
    channels: std::collections::BTreeMap<String, Vec<f32>>,
}

impl Exr {
    fn read(file: &[u8]) -> Self {
        let int = |at: usize| i32::from_le_bytes(file[at..at + 4].try_into().unwrap());
        assert_eq!((int(0), int(4)), (20_000_630, 2));
        let mut at = 8;
        let word = |at: &mut usize| {
            let end = file[*at..].iter().position(|b| *b == 0).unwrap() + *at;
            let word = String::from_utf8(file[*at..end].to_vec()).unwrap();
            *at = end + 1;
            word
        };
        let mut attributes = std::collections::BTreeMap::new();
        loop {
            let name = word(&mut at);
            if name.is_empty() {
                break;
            }
            let (kind, length) = (word(&mut at), int(at) as usize);
            attributes.insert(name, (kind, file[at + 4..at + 4 + length].to_vec()));
            at += 4 + length;
        }
        let own = |name: &str, i: usize| i32::from_le_bytes(attributes[name].1[4 * i..4 * i + 4].try_into().unwrap());
        let size = [own("dataWindow", 2) + 1, own("dataWindow", 3) + 1].map(|v| v as usize);
        // For each channel its name, its pixel type, a flag with three unused bytes, and its sampling.
        let (list, mut names) = (&attributes["channels"].1, Vec::new());
        let mut next = 0;
        while list[next] != 0 {
            let end = next + list[next..].iter().position(|b| *b == 0).unwrap();
            names.push(String::from_utf8(list[next..end].to_vec()).unwrap());
            assert_eq!(list[end + 1..end + 17], [2, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]);
            next = end + 17;
        }
        let mut channels: std::collections::BTreeMap<String, Vec<f32>> =
            names.iter().map(|n| (n.clone(), Vec::new())).collect();
        for y in 0..size[1] {
            let offset = u64::from_le_bytes(file[at + 8 * y..at + 8 * y + 8].try_into().unwrap()) as usize;
            assert_eq!((int(offset), int(offset + 4) as usize), (y as i32, 4 * size[0] * names.len()));
            let line = floats(&file[offset + 8..offset + 8 + 4 * size[0] * names.len()]);
            for (name, numbers) in names.iter().zip(line.chunks(size[0])) {
                channels.get_mut(name).unwrap().extend(numbers);
            }
        }
        Self { attributes, channels }
    }
}

#[test]
fn floats_of_openexr_are_read_back() {
    let (_, mut frame) = rendered(Modality::Depth | Modality::FlowForward);
    (frame.depth[0], frame.depth[1]) = (f32::NEG_INFINITY, f32::NAN);
    let [u, v] = [0, 1].map(|i: usize| frame.flow_forward.iter().map(|f| f[i]).collect::<Vec<f32>>());
    let file = exr(90, 70, &[("forward.v", &v), ("Z", &frame.depth), ("forward.u", &u)]).unwrap();
    let read = Exr::read(&file);
    assert_eq!(read.channels.keys().collect::<Vec<_>>(), ["Z", "forward.u", "forward.v"]);
    for (name, wanted) in [("Z", &frame.depth), ("forward.u", &u), ("forward.v", &v)] {
        assert!(same(&read.channels[name], wanted), "{name}");
    }
    // The attributes that every file must have according to the documentation of the format.
    let must = ["channels", "compression", "dataWindow", "displayWindow", "lineOrder", "pixelAspectRatio"];
    assert!(must.iter().all(|name| read.attributes.contains_key(*name)));
    assert_eq!(read.attributes["compression"].1, [0]);
}

/// A GIF has all pictures with their times, each in nearly its colours.
#[test]
fn gifs_are_read_back() {
    use vc_render::picture::{self, Picture};
    let mut two = Picture::new(40, 30, [30, 60, 200]);
    two.paste(&Picture::new(12, 12, [240, 230, 20]), 8, 8);
    let pictures = [Picture::new(40, 30, [200, 30, 60]), two];
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let file = picture::gif(&pictures, 20).unwrap();
    let mut decoder = options.read_info(file.as_slice()).unwrap();
    for picture in &pictures {
        let frame = decoder.read_next_frame().unwrap().unwrap();
        assert_eq!((frame.delay, frame.width, frame.height), (5, 40, 30));
        let near = |(now, was): (&[u8], &[u8; 3])| (0..3).all(|c| now[c].abs_diff(was[c]) <= 4);
        assert!(frame.buffer.chunks(4).zip(&picture.pixels).all(near));
    }
    assert!(decoder.read_next_frame().unwrap().is_none());
    let other = Picture::new(4, 4, [0; 3]);
    assert!(picture::gif(&[pictures[0].clone(), other], 20).is_err());
    assert!(picture::gif(&[Picture::new(70_000, 1, [0; 3])], 20).is_err());
    assert!(picture::jpeg(&Picture::new(70_000, 1, [0; 3]), 90).is_err());
}

/// Point clouds are read back: a header of lines, then sixteen bytes a point.
#[test]
fn point_clouds_are_read_back() {
    let (_, frame) = rendered(Modality::Position | Modality::Instance);
    let points: Vec<[f32; 3]> = frame.points().map(|(_, point)| point.into()).collect();
    let nodes: Vec<vc_graph::NodeId> = frame.points().map(|(pixel, _)| frame.instance[pixel]).collect();
    let file = ply(&points, &nodes).unwrap();
    let end = b"end_header\n";
    let body = file.windows(end.len()).position(|part| part == end).unwrap() + end.len();
    let head: Vec<&str> = std::str::from_utf8(&file[..body]).unwrap().lines().collect();
    assert_eq!(head[..2], ["ply", "format binary_little_endian 1.0"]);
    assert_eq!(head[2], format!("element vertex {}", points.len()));
    assert_eq!(
        head[3..7].iter().map(|l| l.rsplit(' ').next().unwrap()).collect::<Vec<_>>(),
        ["x", "y", "z", "instance"]
    );
    assert_eq!(file.len() - body, 16 * points.len());
    for ((row, point), node) in file[body..].chunks_exact(16).zip(&points).zip(&nodes) {
        let word = |i: usize| u32::from_le_bytes(row[4 * i..4 * i + 4].try_into().unwrap());
        assert_eq!([0, 1, 2].map(|i| f32::from_bits(word(i))), *point);
        assert_eq!(word(3), node.0);
    }
    assert!(points.len() > 1000 && matches!(ply(&points, &nodes[1..]), Err(RenderError::BadShape { .. })));
}
