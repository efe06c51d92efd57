function mark = file_mark(file)
% FILE_MARK  Returns date and size of a file, to detect changes; [] without a file.
found = dir(file);
mark = [];
if numel(found) == 1
    mark = [found.datenum, found.bytes];
end
end
