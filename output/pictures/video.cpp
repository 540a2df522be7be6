// SPDX-License-Identifier: Apache-2.0
#include "output/pictures/video.hpp"

#include "common/error.hpp"

#include <string>

#ifdef ANEURYSM_WITH_VIDEO
extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}
#endif

namespace aneurysm::pictures
{

namespace fs = std::filesystem;

#ifdef ANEURYSM_WITH_VIDEO

namespace
{

struct Close {
    void operator()(AVFormatContext* x) const
    {
        avio_closep(&x->pb);
        avformat_free_context(x);
    }
    void operator()(AVCodecContext* x) const { avcodec_free_context(&x); }
    void operator()(AVFrame* x) const { av_frame_free(&x); }
    void operator()(AVPacket* x) const { av_packet_free(&x); }
    void operator()(SwsContext* x) const { sws_freeContext(x); }
};
template <class T>
using Owned = std::unique_ptr<T, Close>;

} // namespace

bool can_write_video()
{
    return avcodec_find_encoder(AV_CODEC_ID_VP9) != nullptr;
}

struct Video::Encoder {
    Encoder(const fs::path& name, int width, int height, int rate);

    /// Sends a picture, or null at the end, and writes what comes back.
    void encode(const AVFrame* picture);
    void check(bool good, const std::string& what) const
    {
        if (!good) {
            throw Error(file.string(), "video: " + what, "needed: libavcodec with VP9, and enough space");
        }
    }

    fs::path file;
    fs::path unfinished;
    Owned<AVFormatContext> format;
    Owned<AVCodecContext> codec;
    Owned<AVFrame> frame{av_frame_alloc()};
    Owned<AVPacket> packet{av_packet_alloc()};
    Owned<SwsContext> colors;
    AVStream* stream = nullptr; ///< of format
    std::int64_t count = 0;     ///< pictures
};

Video::Encoder::Encoder(const fs::path& name, int width, int height, int rate)
    : file(name), unfinished(name.string() + ".tmp")
{
    av_log_set_level(AV_LOG_ERROR);
    const AVCodec* const vp9 = avcodec_find_encoder(AV_CODEC_ID_VP9);
    check(vp9 != nullptr, "no encoder for VP9");
    AVFormatContext* made = nullptr;
    check(avformat_alloc_output_context2(&made, nullptr, "webm", nullptr) >= 0, "no WebM");
    format.reset(made);
    format->flags |= AVFMT_FLAG_BITEXACT; // the same pictures make the same bytes
    codec.reset(avcodec_alloc_context3(vp9));
    codec->width = width;
    codec->height = height;
    codec->pix_fmt = AV_PIX_FMT_YUV420P;
    codec->time_base = {1, rate};
    codec->framerate = {rate, 1};
    codec->thread_count = 1;
    codec->flags |= AV_CODEC_FLAG_BITEXACT;
    av_opt_set(codec->priv_data, "crf", "24", 0); // constant quality
    av_opt_set(codec->priv_data, "cpu-used", "4", 0);
    check(avcodec_open2(codec.get(), vp9, nullptr) >= 0, "the encoder can't be opened");
    stream = avformat_new_stream(format.get(), nullptr);
    stream->time_base = codec->time_base;
    check(avcodec_parameters_from_context(stream->codecpar, codec.get()) >= 0, "no parameters");
    check(avio_open(&format->pb, unfinished.c_str(), AVIO_FLAG_WRITE) >= 0, "the file can't be made");
    check(avformat_write_header(format.get(), nullptr) >= 0, "no header");
    frame->format = codec->pix_fmt;
    frame->width = width;
    frame->height = height;
    check(av_frame_get_buffer(frame.get(), 0) >= 0, "no memory");
    colors.reset(sws_getContext(width, height, AV_PIX_FMT_RGB24, width, height, codec->pix_fmt,
                                SWS_BILINEAR | SWS_ACCURATE_RND, nullptr, nullptr, nullptr));
    check(colors != nullptr, "no conversion of colors");
}

void Video::Encoder::encode(const AVFrame* picture)
{
    check(avcodec_send_frame(codec.get(), picture) >= 0, "a picture can't be encoded");
    while (avcodec_receive_packet(codec.get(), packet.get()) >= 0) {
        av_packet_rescale_ts(packet.get(), codec->time_base, stream->time_base);
        packet->stream_index = stream->index;
        check(av_interleaved_write_frame(format.get(), packet.get()) >= 0, "the file can't be written");
    }
}

Video::Video(const fs::path& file, int width, int height, int rate)
    : encoder_(std::make_unique<Encoder>(file, width, height, rate))
{
}

Video::~Video()
{
    if (encoder_) {
        std::error_code unused;
        fs::remove(encoder_->unfinished, unused);
    }
}

void Video::add(const Image& image)
{
    Encoder& e = *encoder_;
    e.check(image.width == e.codec->width && image.height == e.codec->height, "pictures of several sizes");
    e.check(av_frame_make_writable(e.frame.get()) >= 0, "no memory");
    const std::uint8_t* const rows = image.row(0);
    const int stride = 3 * image.width;
    sws_scale(e.colors.get(), &rows, &stride, 0, image.height, e.frame->data, e.frame->linesize);
    e.frame->pts = e.count++;
    e.encode(e.frame.get());
}

void Video::finish()
{
    Encoder& e = *encoder_;
    e.encode(nullptr);
    e.check(av_write_trailer(e.format.get()) >= 0, "the file can't be finished");
    e.format.reset();
    fs::rename(e.unfinished, e.file);
    encoder_.reset();
}

#else

bool can_write_video()
{
    return false;
}

struct Video::Encoder {
};

Video::Video(const fs::path& file, int, int, int)
{
    throw Error(file.string(), "this build can't write videos",
                "needed: libavcodec-dev, libavformat-dev and libswscale-dev when it is built");
}
Video::~Video() = default;
void Video::add(const Image&) {}
void Video::finish() {}

#endif

} // namespace aneurysm::pictures
