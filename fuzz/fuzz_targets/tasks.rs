//! Task files that parse are written and parse back equal; ALFRED's tasks as well.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vc_tasks::format::alfred::Template;
use vc_tasks::format::json;

fuzz_target!(|text: &str| {
    if let Ok(tasks) = json::read(text) {
        assert_eq!(json::read(&json::write(&tasks)).as_ref(), Ok(&tasks));
    }
    if let Ok(task) = Template::read(text) {
        assert_eq!(Template::from_goal(&task.to_goal()).map(|t| t.task_type), Ok(task.task_type));
        assert_eq!(Template::read(&task.write()).as_ref(), Ok(&task));
    }
});
