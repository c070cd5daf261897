//! Jobs on all processors.

use std::sync::Mutex;

/// Does all jobs, as many at a time as there are processors; the first error.
pub(crate) fn in_parallel<J: Sync>(
    jobs: &[J],
    work: impl Fn(&J) -> Result<(), String> + Sync,
) -> Result<(), String> {
    let next = Mutex::new(jobs.iter());
    let failed = Mutex::new(None);
    let workers = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..workers {
            scope.spawn(|| {
                loop {
                    let job = next.lock().ok().and_then(|mut jobs| jobs.next());
                    let Some(job) = job else { return };
                    if let (Err(why), Ok(mut failed)) = (work(job), failed.lock()) {
                        failed.get_or_insert(why);
                    }
                }
            });
        }
    });
    failed.into_inner().ok().flatten().map_or(Ok(()), Err)
}
