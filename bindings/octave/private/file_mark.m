function mark = file_mark(file)
% FILE_MARK  What tells whether a file is still the one that was read: its date and size, [] of none.
found = dir(file);
mark = [];
if numel(found) == 1
    mark = [found.datenum, found.bytes];
end
end
