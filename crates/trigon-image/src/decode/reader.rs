//! A cursor over a file in memory: every read is checked and an end of file is an error that says what was being read.

use crate::{DecodeError, Format};

/// Reads numbers and runs of bytes from the front, for one format's error messages.
pub(super) struct Reader<'a> {
    format: Format,
    bytes: &'a [u8],
    offset: usize,
}

impl<'a> Reader<'a> {
    pub(super) fn new(format: Format, bytes: &'a [u8]) -> Self {
        Self { format, bytes, offset: 0 }
    }

    /// Bytes from the start of the file to the next read.
    pub(super) fn offset(&self) -> usize {
        self.offset
    }

    /// What is left of the file.
    pub(super) fn rest(&self) -> &'a [u8] {
        &self.bytes[self.offset..]
    }

    /// Goes to `offset` from the start of the file.
    pub(super) fn seek(&mut self, offset: usize, what: &str) -> Result<(), DecodeError> {
        if offset > self.bytes.len() {
            return Err(self.ends_inside(what));
        }
        self.offset = offset;
        Ok(())
    }

    /// The next `count` bytes.
    pub(super) fn take(&mut self, count: usize, what: &str) -> Result<&'a [u8], DecodeError> {
        match self.rest().split_at_checked(count) {
            Some((taken, _)) => {
                self.offset += count;
                Ok(taken)
            }
            None => Err(self.ends_inside(what)),
        }
    }

    pub(super) fn array<const N: usize>(&mut self, what: &str) -> Result<[u8; N], DecodeError> {
        let mut array = [0; N];
        array.copy_from_slice(self.take(N, what)?);
        Ok(array)
    }

    pub(super) fn u8(&mut self, what: &str) -> Result<u8, DecodeError> {
        self.array::<1>(what).map(|[byte]| byte)
    }

    pub(super) fn u16_le(&mut self, what: &str) -> Result<u16, DecodeError> {
        self.array(what).map(u16::from_le_bytes)
    }

    pub(super) fn u32_le(&mut self, what: &str) -> Result<u32, DecodeError> {
        self.array(what).map(u32::from_le_bytes)
    }

    pub(super) fn u32_be(&mut self, what: &str) -> Result<u32, DecodeError> {
        self.array(what).map(u32::from_be_bytes)
    }

    pub(super) fn u64_le(&mut self, what: &str) -> Result<u64, DecodeError> {
        self.array(what).map(u64::from_le_bytes)
    }

    /// The bytes up to the next NUL, which is passed over.
    pub(super) fn until_nul(&mut self, what: &str) -> Result<&'a [u8], DecodeError> {
        self.until(0, what)
    }

    /// The bytes up to the next line feed, which is passed over, without a carriage return at their end.
    pub(super) fn line(&mut self, what: &str) -> Result<&'a [u8], DecodeError> {
        let line = self.until(b'\n', what)?;
        Ok(line.strip_suffix(b"\r").unwrap_or(line))
    }

    fn until(&mut self, end: u8, what: &str) -> Result<&'a [u8], DecodeError> {
        let Some(length) = self.rest().iter().position(|&byte| byte == end) else {
            return Err(self.ends_inside(what));
        };
        let taken = self.take(length, what)?;
        self.offset += 1;
        Ok(taken)
    }

    /// The file breaks `rule` at the next byte to read.
    pub(super) fn malformed(&self, rule: impl Into<std::borrow::Cow<'static, str>>) -> DecodeError {
        DecodeError::malformed(self.format, self.offset, rule)
    }

    fn ends_inside(&self, what: &str) -> DecodeError {
        DecodeError::malformed(self.format, self.bytes.len(), format!("the file ends inside the {what}"))
    }
}
