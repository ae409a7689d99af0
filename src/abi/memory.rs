//! Structs and values of the host. Every raw pointer of the interface is read and written here and in `text`.

use core::mem::MaybeUninit;

use super::failure::{CallError, SINS_OK, sins_status};
use crate::base::error::Rule;

/// Largest struct size that a host may state; larger ones are garbage, not a later release.
const MAX_STRUCT_SIZE: usize = 1 << 16;

/// A struct of the interface: begins with `struct_size` and a second 32-bit integer.
///
/// # Safety
/// `repr(C)`, made of integers and floating-point numbers alone: any bytes are a value, and there is no padding.
pub(super) unsafe trait Struct: Copy {
    /// Its name in messages.
    const NAME: &'static str;
    /// Its size in the first release that had it.
    const FIRST_SIZE: usize;
}

/// Declares a struct of the interface with its name in messages and its size in its first release.
macro_rules! interface_struct {
    ($type:ty, $name:literal, $first_size:expr) => {
        const _: () = assert!(size_of::<$type>() >= $first_size && size_of::<$type>() % 8 == 0);
        // SAFETY: repr(C) of numbers, and 32-bit integers come in pairs: no padding.
        unsafe impl $crate::abi::memory::Struct for $type {
            const NAME: &'static str = concat!($name, ".struct_size");
            const FIRST_SIZE: usize = $first_size;
        }
    };
}
pub(super) use interface_struct;

/// Checks a struct size that a host states.
fn check_size<T: Struct>(size: usize) -> Result<usize, CallError> {
    if size < T::FIRST_SIZE || size > MAX_STRUCT_SIZE || !size.is_multiple_of(8) {
        let rule = Rule::Exactly("must be sizeof the struct; in this release", size_of::<T>().into());
        return Err(CallError::struct_size(T::NAME, size, rule));
    }
    Ok(size)
}

/// The struct size at `pointer`.
///
/// # Safety
/// `pointer` is null or points to a struct that begins with its size.
unsafe fn stated_size<T: Struct>(pointer: *const T, name: &'static str) -> Result<usize, CallError> {
    if pointer.is_null() {
        return Err(CallError::null(name));
    }
    // SAFETY: not null; any alignment is read.
    check_size::<T>(unsafe { pointer.cast::<u32>().read_unaligned() } as usize)
}

/// Reads a struct of the host. If it is shorter, the missing fields are zero; if it is longer, the rest must be zero.
///
/// # Safety
/// `pointer` is null or points to a struct of as many readable bytes as its `struct_size` says.
pub(super) unsafe fn read<T: Struct>(pointer: *const T, name: &'static str) -> Result<T, CallError> {
    // SAFETY: as this function.
    let size = unsafe { stated_size(pointer, name)? };
    // SAFETY: `size` bytes are readable.
    unsafe { read_sized(pointer, size) }
}

/// As [`read`], but into a place of the caller, so that a large struct is not moved on the stack.
///
/// # Safety
/// As [`read`].
pub(super) unsafe fn read_into<T: Struct>(
    pointer: *const T,
    name: &'static str,
    value: &mut T,
) -> Result<(), CallError> {
    // SAFETY: as this function.
    let size = unsafe { stated_size(pointer, name)? };
    // SAFETY: `size` bytes are readable; a `T` is writable, and any bytes are one.
    unsafe { copy_sized(pointer, size, value) }
}

/// # Safety
/// `pointer` points to `size` readable bytes.
unsafe fn read_sized<T: Struct>(pointer: *const T, size: usize) -> Result<T, CallError> {
    let mut value = MaybeUninit::<T>::zeroed();
    // SAFETY: as this function; the local is writable.
    unsafe { copy_sized(pointer, size, value.as_mut_ptr())? };
    // SAFETY: any bytes are a `T`.
    Ok(unsafe { value.assume_init() })
}

/// Copies the known fields of a struct. If the host's struct is shorter, the other fields of `value` stay; if it is longer, the rest
/// must be zero.
///
/// # Safety
/// `pointer` points to `size` readable bytes, `value` to a writable `T`.
unsafe fn copy_sized<T: Struct>(pointer: *const T, size: usize, value: *mut T) -> Result<(), CallError> {
    let known = size_of::<T>();
    // SAFETY: the shorter of both lengths; the host's bytes and the library's do not overlap.
    unsafe { core::ptr::copy_nonoverlapping(pointer.cast::<u8>(), value.cast::<u8>(), size.min(known)) };
    for offset in known..size {
        // SAFETY: within the struct's stated size.
        if unsafe { pointer.cast::<u8>().add(offset).read() } != 0 {
            let rule = Rule::Sentence(
                "the struct is of a newer release and uses fields that this release does not know",
            );
            return Err(CallError::struct_size(T::NAME, size, rule));
        }
    }
    Ok(())
}

/// A checked place for a struct to be written to.
pub(super) struct Output<T> {
    pointer: *mut T,
    size: usize,
}

impl<T: Struct> Output<T> {
    /// # Safety
    /// `pointer` is null or points to a struct of as many writable bytes as its `struct_size` says, until `write` or `finish`.
    pub unsafe fn new(pointer: *mut T, name: &'static str) -> Result<Self, CallError> {
        // SAFETY: as this function.
        Ok(Self { pointer, size: unsafe { stated_size(pointer.cast_const(), name)? } })
    }

    /// A place that may be null: none.
    ///
    /// # Safety
    /// As [`Self::new`].
    pub unsafe fn if_wanted(pointer: *mut T, name: &'static str) -> Result<Option<Self>, CallError> {
        // SAFETY: as this function.
        (!pointer.is_null()).then(|| unsafe { Self::new(pointer, name) }).transpose()
    }

    /// Writes all that the host's struct has room for; its `struct_size` stays. That is the end of most calls: their status.
    pub fn write(&self, value: &T) -> sins_status {
        const HEAD: usize = size_of::<u32>();
        let length = self.size.min(size_of::<T>()) - HEAD;
        // SAFETY: `new` was promised that many writable bytes.
        unsafe {
            let from = core::ptr::from_ref(value).cast::<u8>().add(HEAD);
            core::ptr::copy_nonoverlapping(from, self.pointer.cast::<u8>().add(HEAD), length);
        }
        SINS_OK
    }

    /// A struct whose fields are to be set, but for `struct_size`: the host's, if that has room, else `own`. [`Self::finish`] is to follow.
    #[inline(always)]
    pub fn place<'a>(&'a self, own: &'a mut MaybeUninit<T>) -> &'a mut T {
        let place = if self.has_room() {
            self.pointer
        } else {
            *own = MaybeUninit::zeroed();
            own.as_mut_ptr()
        };
        // SAFETY: `new` was promised that many writable bytes, or they are the library's own; any bytes are a `T`.
        unsafe { &mut *place }
    }

    /// Writes what `place` gave, and was set.
    #[inline(always)]
    pub fn finish(&self, place: &mut T) {
        if self.has_room() {
            // SAFETY: the head of the struct.
            unsafe { core::ptr::from_mut(place).cast::<u32>().write(self.size as u32) };
        } else {
            self.write(place);
        }
    }

    fn has_room(&self) -> bool {
        self.size >= size_of::<T>() && self.pointer.is_aligned()
    }
}

/// An array of structs of the host, as far apart as the first one's `struct_size` says.
pub(super) struct Array<T> {
    first: *mut T,
    stride: usize,
    count: usize,
}

impl<T: Struct> Array<T> {
    /// # Safety
    /// `first` is null or points to `count` structs of the size that the first one states.
    pub unsafe fn new(first: *mut T, count: usize, name: &'static str) -> Result<Self, CallError> {
        if count == 0 {
            return Ok(Self { first, stride: size_of::<T>(), count });
        }
        // SAFETY: as this function.
        let stride = unsafe { stated_size(first.cast_const(), name)? };
        Ok(Self { first, stride, count })
    }

    pub fn count(&self) -> usize {
        self.count
    }

    fn element(&self, index: usize) -> Result<*mut T, CallError> {
        if index >= self.count {
            return Err(CallError::buffer(T::NAME, self.count, index + 1));
        }
        // SAFETY: within the array that `new` was promised.
        Ok(unsafe { self.first.cast::<u8>().add(index * self.stride) }.cast::<T>())
    }

    /// Element `index`; its own struct_size is that of the first, or 0.
    pub fn read(&self, index: usize) -> Result<T, CallError> {
        let pointer = self.element(index)?;
        // SAFETY: the head of an element.
        let size = unsafe { pointer.cast::<u32>().read_unaligned() } as usize;
        if size != self.stride && size != 0 {
            let rule = Rule::Exactly("must be 0, or that of the first element:", self.stride.into());
            return Err(CallError::struct_size(T::NAME, size, rule));
        }
        // SAFETY: an element has `stride` readable bytes.
        unsafe { read_sized(pointer.cast_const(), self.stride) }
    }

    /// Element `index`, whose own struct_size is that of the first from then on.
    pub fn write(&self, index: usize, value: &T) -> Result<(), CallError> {
        self.output(index)?.write(value);
        Ok(())
    }

    /// The place of element `index`, whose own struct_size is that of the first from then on.
    #[inline(always)]
    pub fn output(&self, index: usize) -> Result<Output<T>, CallError> {
        let pointer = self.element(index)?;
        // SAFETY: the head of an element, which `new` was promised to be writable.
        unsafe { pointer.cast::<u32>().write_unaligned(self.stride as u32) };
        Ok(Output { pointer, size: self.stride })
    }
}

/// Reads numbers of the host, as many as `to` has.
///
/// # Safety
/// `pointer` is null or points to that many readable numbers, of any alignment.
pub(super) unsafe fn read_numbers(
    pointer: *const f64,
    to: &mut [f64],
    name: &'static str,
) -> Result<(), CallError> {
    if pointer.is_null() && !to.is_empty() {
        return Err(CallError::null(name));
    }
    for (index, number) in to.iter_mut().enumerate() {
        // SAFETY: not null, and within the array.
        *number = unsafe { pointer.add(index).read_unaligned() };
    }
    Ok(())
}

/// Writes `value` to a place of the host, which is the end of most calls: their status.
///
/// # Safety
/// `pointer` is null or points to a writable `T`, of any alignment.
pub(super) unsafe fn put<T: Copy>(
    pointer: *mut T,
    value: T,
    name: &'static str,
) -> Result<sins_status, CallError> {
    if pointer.is_null() {
        return Err(CallError::null(name));
    }
    // SAFETY: not null.
    unsafe { pointer.write_unaligned(value) };
    Ok(SINS_OK)
}

/// Writes `value` to a place of the host, if the host gives one.
///
/// # Safety
/// As [`put`].
pub(super) unsafe fn put_if_wanted<T: Copy>(pointer: *mut T, value: T) {
    if !pointer.is_null() {
        // SAFETY: not null.
        unsafe { pointer.write_unaligned(value) };
    }
}

/// The element `index`; `rule` says what there must be of it.
#[cfg(feature = "scenes")]
pub(super) fn element<'a, T>(list: &'a [T], index: usize, rule: &'static str) -> Result<&'a T, CallError> {
    let rule = Rule::SentenceWith(rule, list.len().into());
    list.get(index).ok_or_else(|| crate::base::error::Error::invalid("index", index, rule).into())
}
