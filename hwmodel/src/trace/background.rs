//! Writing in a thread of its own.

use std::io::{self, Write};
use std::mem;
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::thread::{self, JoinHandle};

/// A buffered writer whose output is written by another thread: much of the time that a wave takes
/// is the operating system's, which copies it into the file.
///
/// ```text
///          ┌─────────┐  full buffers   ┌────────┐
///  write ─▶│ filling ├────────────────▶│ thread ├─▶ output
///          └─────────┘◀────────────────┴────────┘
///                       empty buffers
/// ```
///
/// There are few buffers, and they go round: if the output is slower, a write waits for one.
///
/// An error of the output ends the thread; one of the writes that follow reports it, at the latest
/// the [`flush`](Write::flush). As with [`BufWriter`](io::BufWriter), what is still buffered is
/// written when the writer is dropped, and an error of that is lost: flush or
/// [`finish`](Self::finish) before.
#[derive(Debug)]
pub struct BackgroundWriter<W> {
    filling: Vec<u8>,
    /// Empty buffers at hand; the others come back from the thread.
    spare: Vec<Vec<u8>>,
    written: Receiver<Vec<u8>>,
    thread: Option<Thread<W>>,
}

#[derive(Debug)]
struct Thread<W> {
    /// Its work, which ends with this sender. An empty buffer asks for a flush.
    to_write: SyncSender<Vec<u8>>,
    handle: JoinHandle<io::Result<W>>,
}

/// Buffers, and the bytes of each: so large that the thread is rarely woken up, which takes longer
/// than to copy what comes in meanwhile.
const BUFFERS: usize = 3;
const BYTES: usize = 1 << 19;

impl<W: Write + Send + 'static> BackgroundWriter<W> {
    /// Starts the thread that writes into the output.
    ///
    /// # Errors
    /// The operating system's, if it has no thread to give.
    pub fn new(mut output: W) -> io::Result<Self> {
        let (to_write, full) = sync_channel::<Vec<u8>>(BUFFERS);
        let (back, written) = sync_channel(BUFFERS);
        let work = move || {
            for mut buffer in full {
                match buffer.is_empty() {
                    true => output.flush()?,
                    false => output.write_all(&buffer)?,
                }
                buffer.clear();
                // In the end nobody takes them back.
                let _ = back.send(buffer);
            }
            Ok(output)
        };
        let handle = thread::Builder::new().name("writer".to_owned()).spawn(work)?;
        let mut spare: Vec<_> = (0..BUFFERS).map(|_| Vec::with_capacity(BYTES)).collect();
        let filling = spare.pop().unwrap_or_default();
        Ok(Self { filling, spare, written, thread: Some(Thread { to_write, handle }) })
    }
}

impl<W> BackgroundWriter<W> {
    /// Writes what is still buffered, and gives the output back.
    ///
    /// # Errors
    /// The output's.
    pub fn finish(mut self) -> io::Result<W> {
        self.flush()?;
        self.join()
    }

    /// Hands a buffer to the thread and goes on with an empty one.
    fn hand_over(&mut self) -> io::Result<()> {
        let full = mem::take(&mut self.filling);
        if self.thread.as_ref().is_none_or(|thread| thread.to_write.send(full).is_err()) {
            return Err(self.failure());
        }
        self.filling = match self.spare.pop() {
            Some(empty) => empty,
            None => self.take_back()?,
        };
        Ok(())
    }

    /// Waits for a buffer to be written.
    fn take_back(&mut self) -> io::Result<Vec<u8>> {
        self.written.recv().map_err(|_| self.failure())
    }

    /// Why the thread has ended.
    fn failure(&mut self) -> io::Error {
        self.join().err().unwrap_or_else(|| io::ErrorKind::BrokenPipe.into())
    }

    /// Waits for the thread to end.
    fn join(&mut self) -> io::Result<W> {
        let Some(Thread { to_write, handle }) = self.thread.take() else {
            return Err(io::Error::other("nothing is written after an error"));
        };
        drop(to_write);
        handle.join().unwrap_or_else(|_| Err(io::Error::other("the writing thread panicked")))
    }
}

impl<W> Write for BackgroundWriter<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.filling.len() == BYTES || self.thread.is_none() {
            self.hand_over()?;
        }
        let count = bytes.len().min(BYTES - self.filling.len());
        self.filling.extend_from_slice(&bytes[..count]);
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        if !self.filling.is_empty() {
            self.hand_over()?;
        }
        self.hand_over()?;
        // When all are back, all is written.
        while self.spare.len() < BUFFERS - 1 {
            let empty = self.take_back()?;
            self.spare.push(empty);
        }
        Ok(())
    }
}

impl<W> Drop for BackgroundWriter<W> {
    fn drop(&mut self) {
        if let Some(thread) = &self.thread {
            if !self.filling.is_empty() {
                let _ = thread.to_write.send(mem::take(&mut self.filling));
            }
            let _ = self.join();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::sync::{Arc, Mutex};

    /// An output that can still be looked at when its writer is gone, and takes only so much.
    #[derive(Clone, Debug)]
    struct Shared {
        bytes: Arc<Mutex<Vec<u8>>>,
        flushes: Arc<Mutex<usize>>,
        room: usize,
    }

    impl Shared {
        fn new(room: usize) -> Self {
            Self { bytes: Arc::default(), flushes: Arc::default(), room }
        }
    }

    impl Write for Shared {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            let mut written = self.bytes.lock().unwrap();
            if written.len() + bytes.len() > self.room {
                return Err(io::ErrorKind::StorageFull.into());
            }
            // Not all at once, as an output may.
            let some = bytes.len().div_ceil(2);
            written.extend_from_slice(&bytes[..some]);
            Ok(some)
        }

        fn flush(&mut self) -> io::Result<()> {
            *self.flushes.lock().unwrap() += 1;
            Ok(())
        }
    }

    fn text(length: usize) -> Vec<u8> {
        (0..length).map(|at| (at % 251) as u8).collect()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]
        #[test]
        fn the_bytes_are_those_of_a_direct_write(
            pieces in prop::collection::vec((0..3 * BYTES, any::<bool>()), 0..12),
        ) {
            let output = Shared::new(usize::MAX);
            let mut writer = BackgroundWriter::new(output.clone()).unwrap();
            let mut direct = Vec::new();
            for (length, flushes) in pieces {
                let piece = text(length);
                writer.write_all(&piece).unwrap();
                direct.write_all(&piece).unwrap();
                if flushes {
                    let before = *output.flushes.lock().unwrap();
                    writer.flush().unwrap();
                    prop_assert!(*output.bytes.lock().unwrap() == direct);
                    prop_assert_eq!(*output.flushes.lock().unwrap(), before + 1);
                }
            }
            let output = writer.finish().unwrap();
            prop_assert!(*output.bytes.lock().unwrap() == direct);
        }
    }

    #[test]
    fn nothing_is_lost_when_it_is_dropped() {
        for length in [0, 1, BYTES, 10 * BYTES + 7] {
            let output = Shared::new(usize::MAX);
            let mut writer = BackgroundWriter::new(output.clone()).unwrap();
            writer.write_all(&text(length)).unwrap();
            drop(writer);
            assert!(*output.bytes.lock().unwrap() == text(length));
        }
    }

    #[test]
    fn an_error_of_the_output_is_reported() {
        let mut writer = BackgroundWriter::new(Shared::new(3 * BYTES)).unwrap();
        writer.write_all(&text(3 * BYTES)).unwrap();
        writer.flush().unwrap();
        writer.write_all(b"more").unwrap();
        assert_eq!(writer.flush().unwrap_err().kind(), io::ErrorKind::StorageFull);
        // What follows is refused, not lost in silence.
        assert!(writer.write(b"more").is_err());
        assert!(writer.flush().is_err());
        assert!(writer.finish().is_err());

        let mut writer = BackgroundWriter::new(Shared::new(BYTES)).unwrap();
        let error = writer.write_all(&text(100 * BYTES)).unwrap_err();
        assert_eq!(error.kind(), io::ErrorKind::StorageFull);
    }

    #[test]
    fn a_panic_of_the_output_is_an_error() {
        #[derive(Debug)]
        struct Panicking;
        impl Write for Panicking {
            fn write(&mut self, _: &[u8]) -> io::Result<usize> {
                panic!("as the test wants it")
            }
            fn flush(&mut self) -> io::Result<()> {
                Ok(())
            }
        }
        let mut writer = BackgroundWriter::new(Panicking).unwrap();
        writer.write_all(b"bytes").unwrap();
        assert!(writer.flush().is_err());
    }
}
